package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.SlParser;

/** A change wakes those whom it concerns, and no others. */
class FactFilterTest {
  private static Vocabulary vocabulary;

  @BeforeAll
  static void loadVocabulary() throws IOException {
    try (InputStream turtle = FactFilterTest.class.getResourceAsStream("/bob.ttl")) {
      vocabulary =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl")
              .vocabulary();
    }
  }

  @Test
  void whoAsksForACupIsNotConcernedByWhatIsSeenOfOthers() {
    assertThat(wakes("(canSee ?agent Cup)", "(canSee cam-a Cup)")).isTrue();
    assertThat(wakes("(canSee ?agent Cup)", "(unknown (canSee cam-a Cup))")).isTrue();
    assertThat(wakes("(canSee ?agent Cup)", "(not (canSee cam-a Cup))")).isTrue();
    assertThat(wakes("(canSee ?agent Cup)", "(canSee cam-a Bob)")).isFalse();
    assertThat(wakes("(canSee ?agent ?thing)", "(canSee cam-a Bob)")).isTrue();
    assertThat(wakes("(canSee cam-a ?thing)", "(canSee cam-b Bob)")).isFalse();
  }

  @Test
  void theValueIsWhatChanges() {
    assertThat(wakes("(in Cup zone-a)", "(in Cup zone-b)")).isTrue();
    assertThat(wakes("(in ?thing zone-a)", "(in Cup zone-b)")).isTrue();
    assertThat(wakes("(in Cup zone-a)", "(in Bob zone-a)")).isFalse();
  }

  @Test
  void whatHoldsBothWaysIsToldBothWays() {
    assertThat(wakes("(nextTo Cup ?who)", "(nextTo Bob Cup)")).isTrue();
    assertThat(wakes("(nextTo ?who Cup)", "(nextTo Cup Bob)")).isTrue();
    assertThat(wakes("(nextTo ?who Cup)", "(position Cup \"1 2 0\")")).isTrue();
    assertThat(wakes("(nextTo Cup Bob)", "(position Rose \"1 2 0\")")).isFalse();
  }

  @Test
  void numbersAreOfWhatTheyMeasure() {
    assertThat(wakes("(>= (illuminance zone-a) 72)", "(= (illuminance zone-a) 30)")).isTrue();
    assertThat(wakes("(>= (illuminance zone-a) 72)", "(= (illuminance zone-b) 30)")).isFalse();
    assertThat(wakes("(>= (illuminance ?zone) 72)", "(= (illuminance zone-b) 30)")).isTrue();
  }

  @Test
  void changesSpeakOfWhatTheyAreAbout() {
    FactFilter lost = FactFilter.of(List.of("(unknown (in Cup zone-a))"), vocabulary);

    assertThat(lost.speaksOf("(in Cup zone-b)")).isTrue();
    assertThat(lost.speaksOf("(in Bob zone-a)")).isFalse();
  }

  private static boolean wakes(String condition, String change) {
    FactFilter interest = new FactFilter(vocabulary);
    interest.add(SlParser.formula(condition, vocabulary::isFluent), Map.of());
    return interest.isConcernedBy(FactFilter.of(List.of(change), vocabulary));
  }
}
