package org.maestro.junit;

import java.time.Duration;
import org.assertj.core.api.AbstractAssert;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Assertions on how a goal ended. Failures show the story. */
public final class GoalOutcomeAssert extends AbstractAssert<GoalOutcomeAssert, GoalOutcome> {

  GoalOutcomeAssert(GoalOutcome actual) {
    super(actual, GoalOutcomeAssert.class);
  }

  public GoalOutcomeAssert isReached() {
    return require(actual.reached(), "to be reached, but it was not: " + actual.explanation());
  }

  /** The platform tried, or refused, and gave an explanation. */
  public GoalOutcomeAssert isNotReached() {
    return require(!actual.reached(), "not to be reached, but it was")
        .require(!actual.explanation().isBlank(), "to be explained, but no reason was given");
  }

  /** The platform did not take the goal up at all. */
  public GoalOutcomeAssert isRefused() {
    return require(
        actual.report().id().isEmpty(),
        "to be refused, but it was taken up as " + actual.report().id().orElse(""));
  }

  public GoalOutcomeAssert isConfirmed() {
    return require(
        actual.report().confirmed(), "to be confirmed by a sensor, but nothing has seen it");
  }

  public GoalOutcomeAssert hasCallsAtMost(int most) {
    return require(
        actual.calls() <= most,
        "to need at most " + most + " calls, but it needed " + actual.calls());
  }

  public GoalOutcomeAssert hasCalls(int exactly) {
    return require(
        actual.calls() == exactly,
        "to need " + exactly + " calls, but it needed " + actual.calls());
  }

  public GoalOutcomeAssert hasReplansAtMost(int most) {
    return require(
        actual.replans() <= most,
        "to be planned again at most " + most + " times, but it was " + actual.replans());
  }

  public GoalOutcomeAssert tookAtMost(Duration longest) {
    return require(
        actual.duration().compareTo(longest) <= 0,
        "to take at most " + longest + " of simulated time, but it took " + actual.duration());
  }

  /**
   * @param value in MAESTRO-SL: a name, a number, a quoted text
   */
  public GoalOutcomeAssert hasBinding(String variable, String value) {
    Term bound = actual.binding().get(variable);
    return require(
        bound != null && SlPrinter.print(bound).equals(value),
        "to bind ?" + variable + " to " + value + ", but the binding is " + actual.binding());
  }

  public GoalOutcomeAssert isExplainedBy(String part) {
    return require(
        actual.explanation().contains(part),
        "to be explained by \"" + part + "\", but the explanation is: " + actual.explanation());
  }

  /** The story tells it somewhere. */
  public GoalOutcomeAssert tells(String part) {
    return require(
        actual.story().stream().anyMatch(entry -> entry.text().contains(part)),
        "to tell \"" + part + "\"");
  }

  public GoalOutcomeAssert neverTells(String part) {
    return require(
        actual.story().stream().noneMatch(entry -> entry.text().contains(part)),
        "never to tell \"" + part + "\"");
  }

  /** No step of the story, begun or failed, mentions it. */
  public GoalOutcomeAssert neverUses(String agentLabel) {
    return require(
        actual.story().stream()
            .filter(entry -> entry.kind() == StoryEntry.Kind.STEP)
            .noneMatch(entry -> entry.text().contains(agentLabel)),
        "not to use " + agentLabel);
  }

  private GoalOutcomeAssert require(boolean condition, String expectation) {
    isNotNull();
    if (!condition) {
      failWithMessage(
          "Expected the goal %s %s%nIts story:%n%s",
          actual.goal(), sentence(expectation), actual.storyText());
    }
    return this;
  }

  /** An explanation at its end brings its own full stop. */
  private static String sentence(String words) {
    return words.endsWith(".") ? words : words + ".";
  }
}
