package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.experiment.drawing.Timeline;
import org.maestro.experiment.running.Ending;

class StepsTest {

  @Test
  void eachLastsFromItsBeginToWhatItsAgentReports() {
    Ending ending =
        ending(
            told(10_000, StoryEntry.Kind.STEP, "Step 1 of 2: rose picks up Cup."),
            told(10_500, StoryEntry.Kind.STEP, "Step 2 of 2: lamp-1 shines."),
            told(11_000, StoryEntry.Kind.DONE, "lamp-1 reports: zone-b is lit."),
            told(14_000, StoryEntry.Kind.FAILED, "That failed: rose says: it is too flat."),
            told(14_000, StoryEntry.Kind.STEP, "Step 1 of 1: tim picks up Cup."),
            told(15_000, StoryEntry.Kind.END, "Stopped."));

    assertThat(Steps.of(ending))
        .containsExactly(
            new Timeline.Deed("rose", "rose picks up Cup", 0, 4, false),
            new Timeline.Deed("lamp-1", "lamp-1 shines", 0.5, 1, true),
            new Timeline.Deed("tim", "tim picks up Cup", 4, 5, false));
  }

  private static Ending ending(StoryEntry... story) {
    return new Ending("(nextTo Cup Bob)", Optional.empty(), List.of(story), Duration.ofSeconds(10));
  }

  private static StoryEntry told(long millis, StoryEntry.Kind kind, String text) {
    return new StoryEntry("g1", Duration.ofMillis(millis), kind, text);
  }
}
