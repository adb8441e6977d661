#pragma once
#include <cmath>

#include "fields/base/frame.h"

namespace slackwater {

/// A complex number over any scalar that has exp, sin and cos: double, or the dual numbers of
/// automatic differentiation, for which std::complex is not defined. A horizontal vector is east +
/// i north.
///
/// The products are the textbook four multiplications, without the recovery of infinities that
/// std::complex makes; callers keep their values finite.
template <typename T>
struct Complex {
  T re{};
  T im{};
};

template <typename T>
[[nodiscard]] Complex<T> operator+(const Complex<T>& a, const Complex<T>& b) {
  return {a.re + b.re, a.im + b.im};
}
template <typename T>
[[nodiscard]] Complex<T> operator-(const Complex<T>& a, const Complex<T>& b) {
  return {a.re - b.re, a.im - b.im};
}
template <typename T>
[[nodiscard]] Complex<T> operator-(const Complex<T>& a) {
  return {-a.re, -a.im};
}
template <typename T>
[[nodiscard]] Complex<T> operator*(const Complex<T>& a, const Complex<T>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <typename T>
[[nodiscard]] Complex<T> scaled(const Complex<T>& a, const T& factor) {
  return {a.re * factor, a.im * factor};
}
template <typename T>
[[nodiscard]] Complex<T> reciprocal(const Complex<T>& a) {
  const T norm = a.re * a.re + a.im * a.im;
  return {a.re / norm, -a.im / norm};
}
template <typename T>
[[nodiscard]] Complex<T> operator/(const Complex<T>& a, const Complex<T>& b) {
  return a * reciprocal(b);
}

/// e^a.
template <typename T>
[[nodiscard]] Complex<T> exp(const Complex<T>& a) {
  using std::cos, std::exp, std::sin;
  const T magnitude = exp(a.re);
  return {magnitude * cos(a.im), magnitude * sin(a.im)};
}

/// e^a - 1 without the loss of digits near a = 0.
template <typename T>
[[nodiscard]] Complex<T> expm1(const Complex<T>& a) {
  using std::cos, std::exp, std::expm1, std::sin;
  const T half_sine = sin(a.im * T(0.5));
  return {expm1(a.re) * cos(a.im) - T(2.0) * half_sine * half_sine, exp(a.re) * sin(a.im)};
}

/// The value as `Horizontal`.
[[nodiscard]] inline Horizontal to_horizontal(const Complex<double>& a) { return {a.re, a.im}; }

}  // namespace slackwater
