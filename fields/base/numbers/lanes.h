#pragma once
// For sources that are compiled once per instruction set (fields/wave/sea_kernel.cc,
// twin/step/step_kernel.cc): all of this lies in the namespace of that set, so that the linker
// never takes a function from the wrong one.
#include <array>
#include <cstddef>
#include <cstdint>

#ifndef SLACKWATER_KERNEL
#error "compile this file through slackwater_kernels (cmake/SlackwaterKernels.cmake)"
#endif

#define SLACKWATER_INLINE [[gnu::always_inline]] inline

namespace slackwater::SLACKWATER_KERNEL {

#if defined(__AVX512F__)
inline constexpr std::size_t native_lanes = 8;
#elif defined(__AVX2__)
inline constexpr std::size_t native_lanes = 4;
#else
inline constexpr std::size_t native_lanes = 2;
#endif

using NativeDoubles [[gnu::vector_size(8 * native_lanes)]] = double;
/// The same in memory: at any address that suits a double.
using StoredDoubles [[gnu::vector_size(8 * native_lanes), gnu::aligned(8), gnu::may_alias]] =
    double;
using NativeBits [[gnu::vector_size(8 * native_lanes)]] = std::uint64_t;

/// Doubles side by side in so many registers. Each lane sees the same IEEE operations in the same
/// order whatever the registers, hence the same bits.
template <std::size_t registers>
struct LanesIn {
  static constexpr std::size_t parts = registers;
  static constexpr std::size_t count = registers * native_lanes;
  NativeDoubles part[parts];

  [[nodiscard]] SLACKWATER_INLINE static LanesIn all(double value) {
    LanesIn r;
    for (std::size_t i = 0; i < parts; ++i) r.part[i] = value - NativeDoubles{};
    return r;
  }
  // Register by register: GCC 12 copies the whole by way of the stack, at four times the cost.
  [[nodiscard]] SLACKWATER_INLINE static LanesIn load(const double* from) {
    LanesIn r;
    for (std::size_t i = 0; i < parts; ++i) {
      r.part[i] = *reinterpret_cast<const StoredDoubles*>(from + i * native_lanes);
    }
    return r;
  }
  SLACKWATER_INLINE void store(double* to) const {
    for (std::size_t i = 0; i < parts; ++i) {
      *reinterpret_cast<StoredDoubles*>(to + i * native_lanes) = part[i];
    }
  }
};

/// Eight doubles on every instruction set, as one, two or four registers.
using Lanes = LanesIn<8 / native_lanes>;
/// As many as one register holds: for long formulas, whose values then stay in registers.
using OneRegister = LanesIn<1>;

template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator+(const LanesIn<n>& a, const LanesIn<n>& b) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) r.part[i] = a.part[i] + b.part[i];
  return r;
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator-(const LanesIn<n>& a, const LanesIn<n>& b) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) r.part[i] = a.part[i] - b.part[i];
  return r;
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator*(const LanesIn<n>& a, const LanesIn<n>& b) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) r.part[i] = a.part[i] * b.part[i];
  return r;
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator/(const LanesIn<n>& a, const LanesIn<n>& b) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) r.part[i] = a.part[i] / b.part[i];
  return r;
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator-(const LanesIn<n>& a) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) r.part[i] = -a.part[i];
  return r;
}
// With a number that is the same in all lanes.
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator+(double a, const LanesIn<n>& b) {
  return LanesIn<n>::all(a) + b;
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator+(const LanesIn<n>& a, double b) {
  return a + LanesIn<n>::all(b);
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator-(double a, const LanesIn<n>& b) {
  return LanesIn<n>::all(a) - b;
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator-(const LanesIn<n>& a, double b) {
  return a - LanesIn<n>::all(b);
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator*(double a, const LanesIn<n>& b) {
  return LanesIn<n>::all(a) * b;
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator*(const LanesIn<n>& a, double b) {
  return a * LanesIn<n>::all(b);
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator/(double a, const LanesIn<n>& b) {
  return LanesIn<n>::all(a) / b;
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> operator/(const LanesIn<n>& a, double b) {
  return a / LanesIn<n>::all(b);
}

template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> larger_of(const LanesIn<n>& a, const LanesIn<n>& b) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) {
    r.part[i] = a.part[i] > b.part[i] ? a.part[i] : b.part[i];
  }
  return r;
}
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> smaller_of(const LanesIn<n>& a, const LanesIn<n>& b) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) {
    r.part[i] = a.part[i] < b.part[i] ? a.part[i] : b.part[i];
  }
  return r;
}

using NativeMask [[gnu::vector_size(8 * native_lanes)]] = std::int64_t;

/// For each lane whether a comparison holds.
template <std::size_t n>
struct LaneMask {
  NativeMask part[n];
};
template <std::size_t n>
SLACKWATER_INLINE LaneMask<n> operator<(const LanesIn<n>& a, const LanesIn<n>& b) {
  LaneMask<n> r;
  for (std::size_t i = 0; i < n; ++i) r.part[i] = a.part[i] < b.part[i];
  return r;
}
template <std::size_t n>
SLACKWATER_INLINE LaneMask<n> operator>(const LanesIn<n>& a, const LanesIn<n>& b) {
  return b < a;
}
template <std::size_t n>
SLACKWATER_INLINE LaneMask<n> operator<(const LanesIn<n>& a, double b) {
  return a < LanesIn<n>::all(b);
}
template <std::size_t n>
SLACKWATER_INLINE LaneMask<n> operator>(const LanesIn<n>& a, double b) {
  return LanesIn<n>::all(b) < a;
}

/// Lane by lane, `yes` where the comparison holds, else `no`: both are worked out.
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> select(const LaneMask<n>& holds, const LanesIn<n>& yes,
                                    const LanesIn<n>& no) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) {
    r.part[i] = holds.part[i] ? yes.part[i] : no.part[i];
  }
  return r;
}

template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> absolute(const LanesIn<n>& a) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) {
    r.part[i] = (NativeDoubles)((NativeBits)a.part[i] & 0x7fffffffffffffffU);
  }
  return r;
}

/// Correctly rounded, as IEEE has it.
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> square_root(const LanesIn<n>& a) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t lane = 0; lane < native_lanes; ++lane) {
      r.part[i][lane] = __builtin_sqrt(a.part[i][lane]);
    }
  }
  return r;
}

/// table[whole number in the lane].
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> entry_of(const double* table, const LanesIn<n>& index) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t lane = 0; lane < native_lanes; ++lane) {
      r.part[i][lane] = table[static_cast<std::int32_t>(index.part[i][lane])];
    }
  }
  return r;
}

/// The four numbers of a row of a table with rows of four, each lane its own row.
template <std::size_t n>
SLACKWATER_INLINE std::array<LanesIn<n>, 4> four_entries_of(const double* table,
                                                            const LanesIn<n>& row) {
  std::array<LanesIn<n>, 4> r;
  for (std::size_t i = 0; i < n; ++i) {
    const auto first = [&](std::size_t lane) {
      return table + static_cast<std::ptrdiff_t>(4 * static_cast<std::int32_t>(row.part[i][lane]));
    };
#if defined(__AVX2__) && !defined(__AVX512F__)
    // Four rows, turned into four columns.
    const auto of_lane = [&](std::size_t lane) -> NativeDoubles {
      return *reinterpret_cast<const StoredDoubles*>(first(lane));
    };
    const NativeDoubles a = of_lane(0), b = of_lane(1), c = of_lane(2), d = of_lane(3);
    const NativeDoubles even_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const NativeDoubles odd_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const NativeDoubles even_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const NativeDoubles odd_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    r[0].part[i] = __builtin_shufflevector(even_ab, even_cd, 0, 1, 4, 5);
    r[1].part[i] = __builtin_shufflevector(odd_ab, odd_cd, 0, 1, 4, 5);
    r[2].part[i] = __builtin_shufflevector(even_ab, even_cd, 2, 3, 6, 7);
    r[3].part[i] = __builtin_shufflevector(odd_ab, odd_cd, 2, 3, 6, 7);
#else
    for (std::size_t lane = 0; lane < native_lanes; ++lane)
      for (std::size_t k = 0; k < 4; ++k) r[k].part[i][lane] = first(lane)[k];
#endif
  }
  return r;
}

/// 1.5 2^52: adding it leaves no room for a fraction, so that the sum holds x rounded to a whole
/// number (ties to even) in its lowest bits, for |x| < 2^51.
inline constexpr double rounder = 6755399441055744.0;

/// The whole number at or below x, for |x| < 2^51.
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> whole_below(const LanesIn<n>& x) {
  const LanesIn<n> near = (x + rounder) - rounder;
  return select(near > x, near - 1.0, near);
}

/// 2^n for the whole number n that `shifted` = n + rounder holds; -1022 <= n <= 1022.
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> whole_power_of_two(const LanesIn<n>& shifted) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) {
    // A cast between vectors keeps the bits. What lies above the exponent field is shifted out.
    r.part[i] = (NativeDoubles)(((NativeBits)shifted.part[i] + 1023U) << 52U);
  }
  return r;
}
/// 2^-n likewise.
template <std::size_t n>
SLACKWATER_INLINE LanesIn<n> whole_power_of_half(const LanesIn<n>& shifted) {
  LanesIn<n> r;
  for (std::size_t i = 0; i < n; ++i) {
    r.part[i] = (NativeDoubles)((1023U - (NativeBits)shifted.part[i]) << 52U);
  }
  return r;
}

/// Sum of the eight lanes, in one order for all instruction sets: that of two registers of four.
SLACKWATER_INLINE double sum_of(const Lanes& a) {
  using Pair [[gnu::vector_size(16), gnu::may_alias]] = double;
  alignas(64) double lane[Lanes::count];
  a.store(lane);
  const auto pair = [&](std::size_t i) -> Pair {
    return *reinterpret_cast<const Pair*>(lane + 2 * i);
  };
  const Pair sum = (pair(0) + pair(2)) + (pair(1) + pair(3));
  return sum[0] + sum[1];
}

}  // namespace slackwater::SLACKWATER_KERNEL
