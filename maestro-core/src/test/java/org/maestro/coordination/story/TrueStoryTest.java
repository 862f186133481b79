package org.maestro.coordination.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** A story tells reports from expectations, and what the home states from what nobody knows. */
class TrueStoryTest {
  private static final Home HOME =
      new HomeLoader().load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"));
  private static final String LEVEL = "(= (level lamp-b1) 1)";
  private static final String LIGHT = "(= (illuminance zone-b) 47.13)";

  private final NewsSentences news = new NewsSentences(HOME.vocabulary());

  @Test
  void whatAMemberReportsIsToldApartFromWhatIsExpectedOfItsStep() {
    assertThat(news.report(change(List.of(LEVEL, LIGHT), List.of(LIGHT))))
        .isEqualTo(
            "the level of lamp-b1 is 1; expected so: the illuminance of zone-b is 47.13 lux");
    assertThat(news.report(change(List.of(LIGHT), List.of(LIGHT))))
        .isEqualTo("done; expected so: the illuminance of zone-b is 47.13 lux");
    assertThat(news.report(change(List.of(LEVEL), List.of())))
        .isEqualTo("the level of lamp-b1 is 1");
    assertThat(news.report(change(List.of(), List.of()))).isEqualTo("done");
  }

  @Test
  void aReasonThatIsOnlyExpectedIsCalledSo() {
    assertThat(news.all(change(List.of(LEVEL, LIGHT), List.of(LIGHT))))
        .isEqualTo(
            "the level of lamp-b1 is 1, and it is expected: the illuminance of zone-b is 47.13"
                + " lux");
    assertThat(news.all(change(List.of(LIGHT), List.of(LIGHT))))
        .isEqualTo("it is expected: the illuminance of zone-b is 47.13 lux");
  }

  @Test
  void whatWasKnownAlreadyIsAReportAllTheSame() {
    KnowledgeBase.Change told = change(List.of(LIGHT), List.of(LIGHT, LEVEL)).with(List.of(LEVEL));

    assertThat(told.reported()).containsExactly(LEVEL);
    assertThat(told.expected()).containsExactly(LIGHT);
  }

  @Test
  void whatTheHomeStatesIsKnown() {
    KnownOf known = new KnownOf(HOME, List.of());

    assertThat(known.sentences("Cup")).contains("the mass of Cup is").contains("Where Cup is");
    assertThat(known.sentences("lamp-b1")).doesNotContain("nobody knows");
    assertThat(known.sentences("zone-b")).doesNotContain("nobody knows");
  }

  @Test
  void whereAThingIsIsKnownOnceSomebodySaysSo() {
    assertThat(new KnownOf(HOME, List.of("(in Cup zone-b)")).sentences("Cup"))
        .contains("Cup is in zone-b")
        .doesNotContain("nobody knows");
    assertThat(new KnownOf(HOME, List.of("(nextTo Bob Cup)")).sentences("Cup"))
        .as("that is no place")
        .contains("Where Cup is, nobody knows");
  }

  private static KnowledgeBase.Change change(List<String> facts, List<String> expected) {
    return new KnowledgeBase.Change(
        1, new Source(Source.Kind.EXPECTED, "lamp-b1"), facts, expected);
  }
}
