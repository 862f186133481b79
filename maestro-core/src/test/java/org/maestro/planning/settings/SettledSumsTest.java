package org.maestro.planning.settings;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.planning.BobsHome;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.SmallWorld;
import org.maestro.planning.api.PlanningResult;

/** Numbers that are sums of settings do not depend on the way to the settings. */
class SettledSumsTest {

  /** Four lamps of four levels and a shutter of three make 768 states, whatever their gains. */
  private static final OptimalPlanner JUST_ENOUGH = new OptimalPlanner(768);

  @Test
  void provesWithinTheNumberOfSettingsThatNoneWillDo() {
    assertThat(JUST_ENOUGH.solve(study(2576.123457).task(goal(300))))
        .isInstanceOf(PlanningResult.Impossible.class);
  }

  @Test
  void findsTheOneThatDoes() {
    PlanningResult result = JUST_ENOUGH.solve(study(1803.765432).task(goal(300)));
    assertThat(result).isInstanceOf(PlanningResult.Found.class);
  }

  private static String goal(double least) {
    return "(and (>= (illuminance desk) %s) (<= (illuminance desk) 800))".formatted(least);
  }

  private static SmallWorld study(double daylight) {
    SmallWorld world =
        BobsHome.words()
            .individuals("Zone Place", "desk", "study")
            .word("daylightGain", "fluent", "?s - Device", "?z - Zone")
            .word("opening", "fluent", "?s - Device")
            .facts("(= (illuminance desk) 805.1)", "(= (illuminance study) 1143.7)")
            .feature(
                "adjustLight",
                "level=0,0.25,0.5,1",
                "(not (= (level ?self) ?level))",
                "(and (assign (level ?self) ?level) (forall (?z - Zone) (when (> (gain ?self ?z) 0)"
                    + " (increase (illuminance ?z) (* (gain ?self ?z) (- ?level (level"
                    + " ?self)))))))")
            .feature(
                "adjustShutter",
                "opening=0,0.5,1",
                "(not (= (opening ?self) ?opening))",
                "(and (assign (opening ?self) ?opening) (forall (?z - Zone)"
                    + " (increase (illuminance ?z)"
                    + " (* (daylightGain ?self ?z) (- ?opening (opening ?self))))))");
    double[] gains = {78.73043625, 138.71166400, 111.81458002, 206.67760415};
    for (int i = 0; i < gains.length; i++) {
      String name = "lamp-" + (i + 1);
      world.facts("(= (power " + name + ") " + (i < 2 ? 6 : 9) + ")");
      BobsHome.lamp(
          world,
          name,
          0,
          "(+ 0.3 (* 0.1 (power ?self) (max 0 (- ?level (level ?self)))))",
          "(= (gain " + name + " desk) " + gains[i] + ")",
          "(= (gain " + name + " study) " + gains[3 - i] / 3 + ")");
    }
    return world
        .individuals("Thing Device", "shutter")
        .facts("(= (opening shutter) 0.5)")
        .facts("(= (daylightGain shutter desk) " + daylight + ")")
        .facts("(= (daylightGain shutter study) " + 1.1 * daylight + ")")
        .offer(
            "shutter",
            "adjustShutter",
            "(+ 2 (* 8 (max (- ?opening (opening ?self)) (- (opening ?self) ?opening))))");
  }
}
