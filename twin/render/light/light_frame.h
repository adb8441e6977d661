#pragma once
#include <array>
#include <vector>

#include "twin/render/frame/frame_hits.h"
#include "twin/render/light/lit_scene.h"

namespace slackwater::twin {

/// The light that comes to each pixel, row by row, in that of a place of the usual reflectance,
/// rho = 0.1, which is lit as well as the camera needs (seen_light.h): red, green and blue.
struct LightFrame {
  int wide = 0;
  int high = 0;
  std::vector<std::array<float, 3>> light;
};

/// The light of a picture by single scattering, for each colour apart. Of a place of albedo A that
/// is met at range r, with n its face towards the camera and z its depth:
///
///     place   S = A/rho (D m + sum over lamps of E) exp(-c r)
///     day     D = daylight exp(-K z),  in water m = 1 + 3/4 n_up  (1 for an upright face),
///             in air m = (1 - beam)(1 + n_up)/2 + beam max(0, n . sun)/sun_up unless shadowed
///     lamp    E = R^2 cos(from its axis)/d^2 cos(on the face) exp(-c d) unless shadowed
///     veil    V = D(z of the eye) c int_0^r exp(-(c + K z') s) ds,  z' the look's fall; in air
///             (1 - exp(-c r)) of the sky over the horizon there
///               + sum of R^2 b_b/(2 rho) int_0^r cos(from its axis)/d(s)^2 exp(-c (s + d)) ds
///
/// the second integral by eight points over the logarithm of s + d, as `lamp_veil_per_m`, from
/// wherever the lamp is. It is the inspection's one model, with faces, shadows and colours: green
/// is its light (tests/twin/render/picture_test.cc). That in water 3/4 more of the light comes from
/// above is an estimate; one beam of the sun in water, forward scatter and what scatters twice are
/// left out, and the veil knows no shadows.
///
/// Faces are rounded off: n is the mean of the corners' normals by the place's weights, but across
/// edges of more than 37 degrees; meshes of more than 100 000 triangles are taken as they are.
///
/// The sea from above mirrors the sky by Schlick's 0.02 + 0.98 (1 - cos)^5 and sends up R = 0.33
/// b_b/a of the light (Gordon, Brown and Jacobs 1975, as Kirk 1994 has it; a = mu K - b_b, at
/// least b_b), of which 0.54 leaves the water; what is below it is not seen. From below it shows
/// the sky within its window (index 1.34), and the water's own veil beyond. The sky is the CIE's
/// overcast one, (1 + 2 sin h)/3 (Moon and Spencer 1942); a clear one's is blue, an estimate. The
/// sun glitters in the sea seen from above (sun_glint.h), even where something keeps it off; its
/// disc is not drawn.
///
/// The same bits on any number of threads and on every machine.
/// @param hits    of the same scene and camera
/// @param seed    of materials is the lighting's
[[nodiscard]] LightFrame light_of(const RenderScene& scene, const Lighting& lighting,
                                  const Pinhole& camera, const FrameHits& hits, int threads);
/// The same of some pixels alone, in a frame of that camera.
/// @param pixels  none twice
void light_again(LightFrame& frame, const std::vector<std::size_t>& pixels,
                 const RenderScene& scene, const Lighting& lighting, const Pinhole& camera,
                 const FrameHits& hits, int threads);

}  // namespace slackwater::twin
