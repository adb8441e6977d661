#include "fields/current/wind_stress.h"

#include <gtest/gtest.h>

namespace slackwater::wind_stress_test {
namespace {

TEST(WindStress, FollowsThePaperLaw) {
  struct Row {
    double speed, tau;
  };
  for (const Row& row : {Row{5, 0.03644375}, Row{10, 0.194775}, Row{15, 0.54849375},
                         Row{20, 1.1711}, Row{20.5, 1.2509791875}, Row{25, 1.86046875}}) {
    EXPECT_NEAR(wind_stress_pa({row.speed, 0}).real(), row.tau, 1e-12 * row.tau + 1e-15);
  }
}

TEST(WindStress, PointsAlongTheWindWhateverItsDirection) {
  const double modulus = std::abs(wind_stress_pa({12, 0}));
  for (double deg = 0; deg < 360; deg += 7.5) {
    const Horizontal turn = std::polar(1.0, Angle::from_degrees(deg).radians());
    const Horizontal stress = wind_stress_pa(12.0 * turn);
    EXPECT_LT(std::abs(stress - modulus * turn), 1e-15);
  }
}

TEST(WindStress, HasNoJumpWhereTheLawsSaturate) {
  for (const auto& [law, speed] :
       {std::pair{DragLaw::paper_linear, 20.5}, {DragLaw::saturating_2p6, 22.625}}) {
    const double below = drag_coefficient(speed - 1e-9, law);
    const double above = drag_coefficient(speed + 1e-9, law);
    EXPECT_NEAR(below, above, 1e-12);
    EXPECT_EQ(drag_coefficient(40, law), above);
  }
}

TEST(WindStress, TheTwoLawsAgreeUpToTheFirstSaturationAndPartBeyond) {
  EXPECT_EQ(wind_stress_pa({15, 3}, DragLaw::paper_linear),
            wind_stress_pa({15, 3}, DragLaw::saturating_2p6));
  EXPECT_NEAR(drag_coefficient(30, DragLaw::paper_linear), 2.43e-3, 1e-15);
  EXPECT_NEAR(drag_coefficient(30, DragLaw::saturating_2p6), 2.6e-3, 1e-15);
}

TEST(WindStress, CalmAirHasNoStress) { EXPECT_EQ(wind_stress_pa({0, 0}), Horizontal(0, 0)); }

}  // namespace
}  // namespace slackwater::wind_stress_test
