package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Who could take part in reaching a goal. */
class RelevanceTest {
  private final KnownHome home = KnownHome.ofBob();

  @Test
  void whoChangesOrMeasuresTheLightIsRelevantForIt() {
    assertThat(candidates("(>= (illuminance zone-a) 72)"))
        .containsExactly(
            Map.entry("lamp-a1", List.of("adjustLight")),
            Map.entry("lamp-a2", List.of("adjustLight")),
            Map.entry("lamp-b1", List.of("adjustLight")),
            Map.entry("lamp-b2", List.of("adjustLight")),
            Map.entry("lamp-b3", List.of("adjustLight")),
            Map.entry("lux-a", List.of("measureIllumination")),
            Map.entry("lux-b", List.of("measureIllumination")));
  }

  @Test
  void whatARelevantFeatureNeedsIsRelevantToo() {
    Map<String, List<String>> candidates = candidates("(nextTo Cup Bob)");

    assertThat(candidates.get("rose")).containsExactlyInAnyOrder("place", "pick", "move");
    assertThat(candidates.get("cam-a")).as("to find the cup").contains("observeObject");
    assertThat(candidates.get("lamp-b1")).as("for light to look").containsExactly("adjustLight");
  }

  @Test
  void aDerivedWordIsChangedByWhatItIsDerivedFrom() {
    assertThat(candidates("(handFree rose)").get("rose")).contains("place", "pick");
  }

  @Test
  void whereNobodyChangesAnythingNobodyIsRelevant() {
    assertThat(candidates("(>= (charge rose) 0.5)")).isEmpty();
  }

  private Map<String, List<String>> candidates(String goal) {
    return Relevance.candidates(home.formula(goal), home.home);
  }
}
