package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.knowledge.api.StepAccount;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.Outcome;

class MemberViewTest {
  private static final MemberState HOLDS = state("(in Cup rose)");
  private static final FeatureType DEED = CountedOnceContract.FILL;

  private static final Device DRIER =
      new DescriptionReader(
              new HomeLoader()
                  .load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"))
                  .vocabulary())
          .read(
              """
              {"@context": ["https://w3id.org/maestro/context.jsonld", {"d": "https://example.org/d#"}],
               "id": "d:drier-1", "type": "d:Drier",
               "offers": [{"id": "d:dry", "type": "maestro:Task", "effect": "(warm ?self)",
                 "meanwhile": "(and (shut ?self) (not (warm ?self)))", "cost": "1"}],
               "brings": [
                 {"id": "d:Drier", "type": "owl:Class", "subClassOf": "maestro:Device"},
                 {"id": "d:warm", "type": ["maestro:Predicate", "maestro:Observable"],
                  "arguments": ["?d - Drier"]},
                 {"id": "d:shut", "type": ["maestro:Predicate", "maestro:Observable"],
                  "arguments": ["?d - Drier"]}]}
              """,
              "drier-1");

  private final AtomicInteger asked = new AtomicInteger();
  private final MemberView view = new MemberView("listener", asked::incrementAndGet);

  @Test
  void whatItSaysWhileACallRunsWaitsForTheReport() {
    view.ready(true);
    view.begun("c1", DEED);

    assertThat(view.said(HOLDS)).isEmpty();
    assertThat(view.over()).map(MemberWord::facts).contains(HOLDS.values());
  }

  /** The drier dries, and tells that it is open: its call has to be ended. */
  @Test
  void whatHasToHoldMeanwhileIsToldAtOnceButForWhatTheCallChanges() {
    view.ready(true);
    view.describedAs(DRIER);
    view.begun("c1", DRIER.features().get(0));

    MemberWord told = view.said(state("(warm drier-1)", "(not (shut drier-1))")).orElseThrow();
    assertThat(told.facts()).containsExactly("(not (shut drier-1))");
    assertThat(told.only()).containsExactly("shut");
    assertThat(view.said(state("(warm drier-1)", "(not (shut drier-1))"))).isEmpty();
    assertThat(view.said(state("(warm drier-1)")).orElseThrow().facts()).isEmpty();
    assertThat(view.over()).map(MemberWord::facts).contains(List.of("(warm drier-1)"));
  }

  /** It was lost with the cup in its hand: the end of its call must not tell that it holds it. */
  @Test
  void whatALostMemberSaidBeforeIsNoNews() {
    view.ready(true);
    view.begun("c1", DEED);
    view.said(HOLDS);
    view.ready(false);

    assertThat(view.over()).isEmpty();
  }

  @Test
  void tellsWhatWasSaidBeforeACallFromWhatWasSaidSince() {
    view.said(state("(open)"));
    view.begun("c1", DEED);
    StepAccount before = account("c1", "call");
    view.said(HOLDS);
    StepAccount since = account("c1", "call");

    assertThat(before.last().orElseThrow().moment().isAfter(before.begun())).isFalse();
    assertThat(since.last().orElseThrow().moment().isAfter(since.begun())).isTrue();
    assertThat(since.ended().isAfter(since.last().orElseThrow().moment())).isTrue();
    assertThat(since.last().orElseThrow().facts()).isEqualTo(HOLDS.values());
  }

  @Test
  void aStateThatNamesTheCallAmongThoseThatAreOverIncludesIt() {
    view.begun("c1", DEED);
    view.said(over("call"));

    assertThat(account("c1", "call").includesStep()).isTrue();
    assertThat(account("c1", "another").includesStep()).isFalse();
  }

  @Test
  void aStateThatComesAfterTheResultAndSaysThatTheCallGoesOnWasSaidBefore() {
    view.begun("c1", DEED);
    StepAccount account = account("c1", "call");
    view.over();
    MemberWord late =
        view.said(
                new MemberState(
                    "rose", "1", "working", HOLDS.values(), List.of("call"), List.of(), List.of()))
            .orElseThrow();

    assertThat(account.ended().isAfter(late.moment())).isTrue();
    assertThat(late.moment().isAfter(account.begun())).isTrue();
  }

  @Test
  void soWasOneThatSaysThatAnotherWasOverLast() {
    view.begun("c1", DEED);
    StepAccount first = account("c1", "first");
    view.over();
    view.begun("c2", DEED);
    StepAccount second = account("c2", "second");
    view.over();

    MemberWord late = view.said(over("first")).orElseThrow();
    assertThat(late.moment().isAfter(first.ended())).isTrue();
    assertThat(second.ended().isAfter(late.moment())).isTrue();
    MemberWord last = view.said(over("first", "second")).orElseThrow();
    assertThat(last.moment().isAfter(second.ended())).isTrue();
  }

  @Test
  void aCallThatIsAskedForAgainWasBegunTheFirstTime() {
    view.begun("c1", DEED);
    StepAccount unanswered = view.account("c1", "call", DEED, false).orElseThrow();
    view.over();
    view.said(HOLDS);
    view.begun("c2", DEED);
    StepAccount again = account("c2", "call");

    assertThat(again.begun()).isEqualTo(unanswered.begun());
    assertThat(again.last().orElseThrow().moment().isAfter(again.begun())).isTrue();
  }

  @Test
  void whoSpeaksAroundACallAndDoesNotTellWhatIsOverIsAskedOnce() {
    view.said(HOLDS);
    view.begun("c1", DEED);
    view.said(HOLDS);
    account("c1", "call");
    assertThat(asked).as("it spoke before its result").hasValue(1);
    view.over();
    view.said(HOLDS);
    assertThat(asked).as("it has been asked").hasValue(1);

    view.begun("c2", DEED);
    account("c2", "another");
    view.over();
    assertThat(asked).as("it has said nothing").hasValue(1);
    view.said(HOLDS);
    assertThat(asked).as("it spoke after its result").hasValue(2);
  }

  @Test
  void whoTellsWhatIsOverIsNotAsked() {
    view.begun("c1", DEED);
    view.said(over("call"));
    account("c1", "call");
    view.over();
    view.said(over("call"));

    assertThat(asked).hasValue(0);
  }

  private StepAccount account(String conversation, String call) {
    return view.account(conversation, call, DEED, true).orElseThrow();
  }

  private static MemberState over(String... calls) {
    return new MemberState(
        "rose",
        "1",
        "standby",
        HOLDS.values(),
        List.of(),
        List.of(),
        List.of(),
        Stream.of(calls).map(call -> new MemberState.Ended(call, Outcome.SUCCEEDED)).toList());
  }

  private static MemberState state(String... facts) {
    return new MemberState("rose", "1", "standby", List.of(facts), List.of(), List.of(), List.of());
  }
}
