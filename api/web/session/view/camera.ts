// What part of the plane a canvas shows: metres east and north to pixels right and down, and back.

export interface Plane {
  east_m: number;
  north_m: number;
}
export interface Pixel {
  x: number;
  y: number;
}

const LEAST_PIXELS_PER_METRE = 0.002;
const MOST_PIXELS_PER_METRE = 200;

export class Camera {
  east_m = 0;
  north_m = 0;
  pixels_per_metre = 4;
  width = 1;
  height = 1;

  to_pixel(at: Plane): Pixel {
    return {
      x: this.width / 2 + (at.east_m - this.east_m) * this.pixels_per_metre,
      y: this.height / 2 - (at.north_m - this.north_m) * this.pixels_per_metre,
    };
  }

  to_plane(pixel: Pixel): Plane {
    return {
      east_m: this.east_m + (pixel.x - this.width / 2) / this.pixels_per_metre,
      north_m: this.north_m - (pixel.y - this.height / 2) / this.pixels_per_metre,
    };
  }

  pan(right_px: number, down_px: number): void {
    this.east_m -= right_px / this.pixels_per_metre;
    this.north_m += down_px / this.pixels_per_metre;
  }

  /** The place under `pixel` stays under it. */
  zoom(factor: number, pixel: Pixel): void {
    const before = this.to_plane(pixel);
    const wanted = this.pixels_per_metre * factor;
    this.pixels_per_metre = Math.min(
      MOST_PIXELS_PER_METRE,
      Math.max(LEAST_PIXELS_PER_METRE, wanted),
    );
    const after = this.to_plane(pixel);
    this.east_m += before.east_m - after.east_m;
    this.north_m += before.north_m - after.north_m;
  }

  look_at(at: Plane): void {
    this.east_m = at.east_m;
    this.north_m = at.north_m;
  }

  /** All of `places`, with a margin; not closer than `least_m` across. */
  fit(places: readonly Plane[], least_m = 20): void {
    if (places.length === 0) return;
    const east = places.map((it) => it.east_m);
    const north = places.map((it) => it.north_m);
    const [west, most_east] = [Math.min(...east), Math.max(...east)];
    const [south, most_north] = [Math.min(...north), Math.max(...north)];
    this.look_at({ east_m: (west + most_east) / 2, north_m: (south + most_north) / 2 });
    const across_m = Math.max(least_m, (most_east - west) * 1.3);
    const along_m = Math.max(least_m, (most_north - south) * 1.4);
    this.pixels_per_metre = Math.min(
      MOST_PIXELS_PER_METRE,
      this.width / across_m,
      this.height / along_m,
    );
  }
}

/** The greatest of 1, 2, 5, 10, 20, … that is not above `most`. */
export function round_below(most: number): number {
  const decade = 10 ** Math.floor(Math.log10(most));
  const digit = most / decade;
  return (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * decade;
}
