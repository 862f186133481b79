package org.maestro.random;

import java.time.Duration;
import java.util.Optional;
import org.maestro.sl.Formula;

/** The claims about one maintenance goal, judged as long as it is to be held. */
final class Holding {
  /** In this time a loss has to be told: a sensor's news, a new attempt, a decision. */
  private static final Duration SILENCE = Duration.ofSeconds(20);

  private final String goal;
  private final Formula condition;
  private final Judge judge;
  private Optional<Verdict> worst = Optional.empty();
  private boolean isSo;
  private Duration lastTrue = Duration.ZERO;

  Holding(String goal, Formula condition, Judge judge) {
    this.goal = goal;
    this.condition = condition;
    this.judge = judge;
  }

  void told(Claim claim, Duration now) {
    isSo = claim.reached();
    lastTrue = now;
    if (!claim.isLossOnly()) {
      add(judge.of(condition, claim, now));
    }
  }

  private void add(Verdict verdict) {
    if (worst.isEmpty() || verdict.kind().compareTo(worst.get().kind()) > 0) {
      worst = Optional.of(verdict);
    }
  }

  void timePassed(Duration now) {
    if (!isSo || judge.isTrueLately(condition) || !judge.canBeMeasured(condition, now)) {
      lastTrue = now;
    } else if (now.minus(lastTrue).compareTo(SILENCE) > 0) {
      add(
          new Verdict(
              goal,
              Verdict.Kind.FALSELY_ACHIEVED,
              "held",
              "it has not been so for %d s, and nobody was told".formatted(SILENCE.toSeconds())));
    }
  }

  boolean isJudged() {
    return worst.isPresent();
  }

  Verdict verdict() {
    return worst.orElse(Verdict.withoutEnd(goal));
  }
}
