package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Expression;
import org.maestro.sl.Term;

/** What a member does not say of itself any more is not believed any more. */
class WithdrawnWordTest {
  private static final String LAMP = "lamp-b1";

  private final Home home =
      new HomeLoader().load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"));
  private final KnowledgeBase knowledge = new CollectiveKnowledge(home, new SteppedClock());
  private final MemberNews news = news();
  private long statesHeard;

  @BeforeEach
  void itTellsItsLevel() {
    news.changed(lamp(Optional.of(state(List.of("(= (level %s) 0.25)".formatted(LAMP))))));
    assertThat(level()).hasValue(0.25);
  }

  @Test
  void noneOfItWhenTheStateIsEmpty() {
    news.changed(lamp(Optional.of(state(List.of()))));
    assertThat(level()).isEmpty();
  }

  @Test
  void noneOfItWhenTheStateIsCleared() {
    news.changed(lamp(Optional.empty()));
    assertThat(level()).isEmpty();
  }

  @Test
  void allOfItWhenOtherNewsComes() {
    RatsLink.Member now = lamp(Optional.empty());
    news.changed(
        new RatsLink.Member(
            LAMP, now.phase(), now.boot(), Optional.of("{ }"), now.state(), --statesHeard));
    assertThat(level()).hasValue(0.25);
  }

  private OptionalDouble level() {
    return knowledge
        .snapshot()
        .number(new Expression.Fluent("level", List.of(new Term.Name(LAMP))));
  }

  private MemberNews news() {
    return new MemberNews(
        LAMP,
        new MemberView("listener", () -> {}),
        (description, speaker) -> home.devices().get(LAMP),
        new MemberNews.Listener() {
          @Override
          public void described(String description) {
            // It is, with the first news.
          }

          @Override
          public void said(MemberWord word) {
            knowledge.state(LAMP, word);
          }

          @Override
          public void lost(String reason) {
            throw new AssertionError(reason);
          }
        });
  }

  private RatsLink.Member lamp(Optional<MemberState> state) {
    return new RatsLink.Member(
        LAMP, MemberStatus.Phase.READY, "b", Optional.of("{}"), state, ++statesHeard);
  }

  private static MemberState state(List<String> facts) {
    return new MemberState(LAMP, "b", "standby", facts, List.of(), List.of(), List.of());
  }
}
