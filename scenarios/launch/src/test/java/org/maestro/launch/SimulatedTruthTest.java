package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.console.truth.TrueThing;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;

class SimulatedTruthTest {

  @Test
  void tellsWhatIsWhereAndWhatLampsAndDoorsAreAt() {
    Home home = Shipped.home("bob");
    try (LocalSite site =
        LocalSite.stepped(
            SiteSettings.of("true", home)
                .scene(Shipped.scene(Shipped.usualScene("bob").orElseThrow(), home))
                .build())) {
      site.world().moveByHand("Cup", new Position(1, 2, 0));
      site.world().setDoor("door-ab", false);

      Map<String, TrueThing> things =
          SimulatedTruth.of(site).now().stream()
              .collect(Collectors.toMap(TrueThing::name, Function.identity()));

      assertThat(things.get("Cup").at()).contains(new TrueThing.Spot(1, 2));
      assertThat(things.get("Cup").holder()).isEmpty();
      assertThat(things.get("rose").at()).isPresent();
      assertThat(things.get("door-ab").open()).isEqualTo(Optional.of(false));
      assertThat(things.get("lamp-a1").level()).hasValue(site.world().lampLevel("lamp-a1"));
    }
  }
}
