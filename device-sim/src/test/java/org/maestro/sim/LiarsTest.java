package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.maestro.hal.Position;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.world.Flaw;

/** Bases and cameras that are broken and do not say so. */
class LiarsTest {
  private final Homes homes = Homes.bob("bob-lit");

  @AfterEach
  void close() {
    homes.close();
  }

  private Result call(String member, String feature, Map<String, Object> parameters) {
    return homes.call(member, feature, parameters).result().orElseThrow();
  }

  @ParameterizedTest
  @EnumSource(names = {"STANDING", "SPINNING"})
  void aBaseSaysThatItHasDrivenAndStays(Flaw flaw) {
    Position before = homes.world().position("rose").orElseThrow();
    homes.world().flaw("rose", flaw);

    assertThat(call("rose", "move", Map.of("to", Homes.ref("zone-a"))).outcome())
        .isEqualTo(Outcome.SUCCEEDED);
    assertThat(homes.world().position("rose")).contains(before);
  }

  /** It stands in B, and its hand is where it believes that the cup is not. */
  @Test
  void whoseWheelsSpunReachesWhereTheThingIsNot() {
    homes.world().flaw("rose", Flaw.SPINNING);
    call("rose", "move", Map.of("to", Homes.ref("zone-a")));

    Result picked = call("rose", "pick", Map.of("object", homes.at("Cup")));

    assertThat(picked.outcome()).isNotEqualTo(Outcome.SUCCEEDED);
    assertThat(homes.world().holder("Cup")).isEmpty();
  }

  @Test
  void aSoundCameraSeesWhatIsThereAndNothingElse() {
    assertThat(seesCup()).isEqualTo(true);
    homes.world().hide("Cup", true);
    assertThat(seesCup()).isEqualTo(false);
  }

  @Test
  void aBlindCameraSeesNothingOfWhatIsThere() {
    homes.world().flaw("cam-b", Flaw.BLIND);
    assertThat(seesCup()).isEqualTo(false);
  }

  @Test
  void oneThatSeesThingsSeesWhatIsNotThere() {
    homes.world().flaw("cam-b", Flaw.SEEING_THINGS);
    homes.world().hide("Cup", true);
    assertThat(seesCup()).isEqualTo(true);
  }

  private Object seesCup() {
    homes.world().moveByHand("Cup", new Position(4.2, 1.2, 0));
    for (String lamp : List.of("lamp-b1", "lamp-b2", "lamp-b3")) {
      call(lamp, "adjustLight", Map.of("level", 1.0));
    }
    return homes
        .call("cam-b", "observeObject", Map.of("object", Homes.ref("Cup")))
        .values()
        .get("found");
  }
}
