package org.maestro.knowledge.learning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.Household;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase.Change;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.knowledge.api.Moment;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StepAccount;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Expression;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** What a member says of itself around a step, in all orders in which that may come to be known. */
class OwnWordTest {

  private static final String LAMP = "lamp-b1";
  private static final FeatureType FILL =
      Household.feature("(and (increase (level ?self) 20) (open ?self))", "");

  private static final FeatureType FILL_AND_TURN =
      Household.feature("(and (increase (level ?self) 20) (open ?self) (in rose zone-b))", "");

  private final Household home = new Household();
  private Snapshot before;

  @BeforeEach
  void empty() {
    hears(1, "(= (level lamp-b1) 0)", "(not (open lamp-b1))");
    before = home.knowledge.snapshot();
  }

  @AfterEach
  void close() {
    home.close();
  }

  @Test
  void whatItReportedBeforeTheResultIsNotCountedTwice() {
    hears(3, "(= (level lamp-b1) 20)");
    learns(2, 4, word(3, "(= (level lamp-b1) 20)"), false);

    is(20, Source.Kind.STATED);
  }

  @Test
  void norWhenTheResultIsLearntFirst() {
    learns(2, 4, word(3, "(= (level lamp-b1) 20)"), false);
    is(20, Source.Kind.STATED);
    hears(3, "(= (level lamp-b1) 20)");

    is(20, Source.Kind.STATED);
  }

  @Test
  void whatItReportsAfterTheResultStandsThoughItIsKnownBeforeTheResult() {
    hears(5, "(= (level lamp-b1) 20)");
    learns(2, 4, word(1, "(= (level lamp-b1) 0)"), false);

    is(20, Source.Kind.STATED);
  }

  @Test
  void whatItReportsAfterTheResultStandsAlsoWhenItSaysThatNothingWasDone() {
    learns(2, 4, word(1, "(= (level lamp-b1) 0)"), false);
    is(20, Source.Kind.EXPECTED);
    hears(5, "(= (level lamp-b1) 0)", "(not (open lamp-b1))");

    is(0, Source.Kind.STATED);
    assertThat(home.truth("(open lamp-b1)")).isEqualTo(Truth.FALSE);
  }

  @Test
  void whoNeverReportsIsExpectedToHaveDoneIt() {
    learns(2, 4, word(1, "(= (level lamp-b1) 0)"), false);

    is(20, Source.Kind.EXPECTED);
    assertThat(home.truth("(open lamp-b1)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void theValueOfBeforeReportedWhileTheStepGoesOnDoesNotHideTheEffect() {
    MemberWord periodic = word(3, "(= (level lamp-b1) 0)", "(not (open lamp-b1))");
    learns(2, 4, periodic, false);
    home.knowledge.state(LAMP, periodic);

    is(20, Source.Kind.EXPECTED);
    assertThat(home.truth("(open lamp-b1)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void butItStandsWhenTheMemberSaysThatTheStepIsOver() {
    learns(2, 4, word(3, "(= (level lamp-b1) 0)", "(not (open lamp-b1))"), true);

    is(0, Source.Kind.STATED);
    assertThat(home.truth("(open lamp-b1)")).isEqualTo(Truth.FALSE);
  }

  @Test
  void whatALostMemberWasChangingIsNotKnownThoughItHadToldOfIt() {
    home.knowledge.state("lamp-b2", word(2, "(= (level lamp-b1) 5)"));
    home.knowledge.lost("lamp-b2");
    home.knowledge.learn(
        new FeatureRun(
            "lamp-b2",
            Household.feature("(increase (level lamp-b1) 20)", ""),
            Map.of(),
            false,
            Map.of(),
            List.of(),
            Optional.of(before),
            true,
            Optional.empty()));

    assertThat(home.number("(level lamp-b1)")).isEmpty();
  }

  /** Who says that a part of it is not so is not believed the rest. */
  @Test
  void andThenNothingElseOfTheStepIsExpected() {
    Change change =
        learns(2, 4, word(3, "(not (open lamp-b1))", "(= (level lamp-b1) 7)"), true, FILL_AND_TURN);

    assertThat(change.denials()).containsExactly("(not (open lamp-b1))");
    assertThat(home.truth("(in rose zone-b)")).isNotEqualTo(Truth.TRUE);
    is(7, Source.Kind.STATED);
  }

  @Test
  void whoMaySpeakOfBeforeDeniesNothing() {
    Change change = learns(2, 4, word(3, "(not (open lamp-b1))"), false, FILL_AND_TURN);

    assertThat(change.denials()).isEmpty();
    assertThat(home.truth("(in rose zone-b)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void anotherNumberThanExpectedDeniesNothing() {
    Change change = learns(2, 4, word(3, "(= (level lamp-b1) 0)"), true, FILL_AND_TURN);

    assertThat(change.denials()).isEmpty();
    assertThat(home.truth("(in rose zone-b)")).isEqualTo(Truth.TRUE);
  }

  /**
   * A sensor that has said how it is, and is gone, says nothing of how it is now; who goes on
   * saying so does.
   */
  @Test
  void whatALostSensorToldOfOthersIsNotKnownAnyMore() {
    home.knowledge.state("cam-a", word(2, "(= (level lamp-b1) 5)", "(in Cup zone-b)"));
    is(5, Source.Kind.STATED);

    home.knowledge.lost("cam-a");

    assertThat(home.number("(level lamp-b1)")).isEmpty();
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.UNKNOWN);
  }

  /** What it added was in what the sensor of another told before its result came. */
  @Test
  void whatAnotherTellsOfItsOwnAccordIsNotCountedTwice() {
    home.knowledge.state("lamp-b2", word(3, "(= (level lamp-b1) 20)"));
    learns(2, 4, word(1, "(not (open lamp-b1))"), false);

    assertThat(home.number("(level lamp-b1)")).hasValue(20);
  }

  @Test
  void whatAnotherTellsLaterStandsAboveWhatWasOnlyExpected() {
    learns(2, 4, word(1, "(not (open lamp-b1))"), false);
    is(20, Source.Kind.EXPECTED);

    home.knowledge.state("lamp-b2", word(5, "(= (level lamp-b1) 3)"));

    is(3, Source.Kind.STATED);
  }

  @Test
  void whoReadsOneThingAndSaysAnotherOfTheSameIsNotBelieved() {
    Change change = reads(50, 4, word(3, "(= (level lamp-b1) 20)"), true);

    assertThat(change.denials()).containsExactly("(= (level lamp-b1) 20)");
    is(20, Source.Kind.STATED);
  }

  @Test
  void readingsThatDifferByAsMuchAsReadingsDoAreTheSame() {
    Change change = reads(20.5, 4, word(3, "(= (level lamp-b1) 20)"), true);

    assertThat(change.denials()).isEmpty();
    is(20.5, Source.Kind.OBSERVED);
  }

  @Test
  void whatItSaidBeforeItHadReadDeniesNothing() {
    Change change = reads(50, 4, word(3, "(= (level lamp-b1) 20)"), false);

    assertThat(change.denials()).isEmpty();
    is(50, Source.Kind.OBSERVED);
  }

  @Test
  void whatItHasDoneOtherwiseStandsAbovePrediction() {
    learns(2, 4, word(3, "(= (level lamp-b1) 17)"), true);

    is(17, Source.Kind.STATED);
  }

  @Test
  void thoughItIsNotCertainWhenItMayHaveBeenSaidBeforeAllWasDone() {
    learns(2, 4, word(3, "(= (level lamp-b1) 17)"), false);

    is(17, Source.Kind.EXPECTED);
  }

  @Test
  void aWordSaidBeforeTheStepThatIsKnownLateIsWhatTheStepAddsTo() {
    learns(3, 4, word(2, "(= (level lamp-b1) 5)"), false);
    is(25, Source.Kind.EXPECTED);
    hears(2, "(= (level lamp-b1) 5)");

    is(25, Source.Kind.EXPECTED);
  }

  @Test
  void theNextStepCountsThoughTheReportOfTheFirstComesWhileItGoesOn() {
    learns(2, 3, word(1, "(= (level lamp-b1) 0)"), false);
    before = home.knowledge.snapshot();
    learns(4, 6, word(5, "(= (level lamp-b1) 20)"), false);

    is(40, Source.Kind.EXPECTED);
  }

  @Test
  void whatTwoStepsAtOnceShareInOneReportIsNotKnown() {
    MemberWord said = word(4, "(= (level lamp-b1) 20)");
    learns(2, 5, said, false);
    learns(3, 6, said, false);

    assertThat(home.number("(level lamp-b1)")).isEmpty();
  }

  @Test
  void norWhatOneStepAddsToAReportThatAnotherHasTaughtFrom() {
    learns(2, 4, word(1, "(= (level lamp-b1) 0)"), false);
    learns(3, 6, word(5, "(= (level lamp-b1) 20)"), false);

    assertThat(home.number("(level lamp-b1)")).isEmpty();
  }

  @Test
  void stepsThatFollowEachOtherAreBothCountedThoughNothingIsReported() {
    learns(2, 4, word(1, "(= (level lamp-b1) 0)"), false);
    learns(3, 6, word(1, "(= (level lamp-b1) 0)"), false);

    is(40, Source.Kind.EXPECTED);
  }

  @Test
  void ofAStepOfAFormerLifeTheMembersWordStands() {
    hears(2, "(= (level lamp-b1) 20)");
    StepAccount account =
        new StepAccount(
            moment(3), moment(4), Optional.of(word(2, "(= (level lamp-b1) 20)")), false);
    learn(FILL, Optional.empty(), account.begunLongAgo());

    is(20, Source.Kind.EXPECTED);
  }

  @Test
  void whatNobodyCanReadTeachesNothingAndHindersNothing() {
    learns(2, 4, word(3, "(= (level lamp-b1"), false);

    is(20, Source.Kind.EXPECTED);
  }

  /** An agent that moved counts anew. */
  @Test
  void anotherListenerIsHeard() {
    hears(9, "(= (level lamp-b1) 20)");
    home.knowledge.state(
        LAMP, new MemberWord(List.of("(= (level lamp-b1) 30)"), new Moment("another", 1)));

    is(30, Source.Kind.STATED);
  }

  @Test
  void whatWasSaidEarlierAndIsKnownLaterWithdrawsNothing() {
    hears(5, "(= (level lamp-b1) 20)", "(open lamp-b1)");
    hears(4, "(= (level lamp-b1) 10)");

    is(20, Source.Kind.STATED);
    assertThat(home.truth("(open lamp-b1)")).isEqualTo(Truth.TRUE);
  }

  private void hears(long number, String... facts) {
    home.knowledge.state(LAMP, word(number, facts));
  }

  private void learns(long begun, long ended, MemberWord last, boolean includesStep) {
    learns(begun, ended, last, includesStep, FILL);
  }

  private Change learns(
      long begun, long ended, MemberWord last, boolean includesStep, FeatureType feature) {
    return learn(
        feature,
        Optional.of(before),
        new StepAccount(moment(begun), moment(ended), Optional.of(last), includesStep));
  }

  private Change reads(double level, long ended, MemberWord last, boolean includesStep) {
    return home.knowledge.learn(
        new FeatureRun(
            LAMP,
            Household.feature("(sense (level ?self))", "(assign (level ?self) ?lux)"),
            Map.of(),
            true,
            Map.of("lux", new Term.Number(level)),
            List.of(),
            Optional.of(before),
            true,
            Optional.of(
                new StepAccount(moment(2), moment(ended), Optional.of(last), includesStep))));
  }

  private Change learn(FeatureType feature, Optional<Snapshot> known, StepAccount account) {
    return home.knowledge.learn(
        new FeatureRun(
            LAMP, feature, Map.of(), true, Map.of(), List.of(), known, true, Optional.of(account)));
  }

  private static MemberWord word(long number, String... facts) {
    return new MemberWord(List.of(facts), moment(number));
  }

  private static Moment moment(long number) {
    return new Moment("listener", number);
  }

  private void is(double level, Source.Kind kind) {
    assertThat(home.number("(level lamp-b1)")).hasValue(level);
    assertThat(
            home.knowledge
                .snapshot()
                .belief(new Expression.Fluent("level", List.of(new Term.Name(LAMP)))))
        .map(belief -> belief.source().kind())
        .contains(kind);
  }
}
