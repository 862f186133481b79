package org.maestro.random;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;

/**
 * Compares claims with the truth. A claim that something is reached holds when it was so at some
 * moment of the last seconds: a report takes that long. A claim that it is impossible fails when it
 * can surely be done with what could be used for as long.
 */
final class Judge {
  /** From what a sensor saw to the claim: one look, messages, a decision. */
  static final Duration NEWS = Duration.ofSeconds(3);

  /** What came back so lately may not have been used yet. */
  private static final Duration SETTLED = Duration.ofSeconds(5);

  private static final Duration BETWEEN_MOMENTS = Duration.ofMillis(200);

  private final Site site;
  private final Supplier<Moment> present;
  private final Supplier<Snapshot> believed;
  private final Deque<Moment> recent = new ArrayDeque<>();
  private final Map<String, Duration> changedAt = new TreeMap<>();
  private final List<Formula> held = new ArrayList<>();
  private final Set<String> cut = new TreeSet<>();
  private final Set<String> flawed = new TreeSet<>();
  private Duration slowest = Duration.ZERO;
  private Duration lastFault = Duration.ofDays(-1);
  private Duration disturbedUntil = Duration.ofDays(-1);
  private Duration longestDisturbed = Duration.ZERO;

  /**
   * @param believed by whom it judges, now
   */
  Judge(Site site, Supplier<Moment> present, Supplier<Snapshot> believed) {
    this.site = site;
    this.present = present;
    this.believed = believed;
  }

  /** To be told of the passing of time, as often as anything happens; returns whether it looked. */
  boolean timePassed(Duration now) {
    boolean due =
        recent.isEmpty() || now.minus(recent.getLast().at()).compareTo(BETWEEN_MOMENTS) >= 0;
    if (due) {
      recent.addLast(present.get());
      while (recent.getFirst().at().compareTo(now.minus(NEWS).minus(slack(now))) < 0) {
        recent.removeFirst();
      }
    }
    return due;
  }

  /** To be told of each fault as it strikes. */
  void struck(Fault fault, Duration now) {
    lastFault = lastFault.compareTo(now) > 0 ? lastFault : now;
    if (fault instanceof Fault.Death death) {
      changedAt.put(death.device(), now);
    } else if (fault instanceof Fault.Revival revival) {
      changedAt.put(revival.device(), now);
    } else if (fault instanceof Fault.Cut gone) {
      changedAt.put(gone.member(), now);
      cut.add(gone.member());
    } else if (fault instanceof Fault.Return back) {
      changedAt.put(back.member(), now);
      cut.remove(back.member());
    } else if (fault instanceof Fault.Flawed lies) {
      flawed.add(lies.device());
    } else if (fault instanceof Fault.Weakness weakness) {
      site.weakened(weakness.lamp(), weakness.strength());
    } else if (fault instanceof Fault.BrokerDown down) {
      disturbed(now.plus(down.lasts()), down.lasts());
    } else if (fault instanceof Fault.Frozen frozen) {
      disturbed(now.plus(frozen.lasts()), frozen.lasts());
    } else if (fault instanceof Fault.Disturbed disturbed) {
      disturbed(now.plus(disturbed.lasts()), disturbed.lasts());
    } else if (fault instanceof Fault.Delay delay && delay.extra().compareTo(slowest) > 0) {
      slowest = delay.extra();
    }
  }

  /** Until its end nobody may be there, and what is known may be as old as it is. */
  private void disturbed(Duration until, Duration lasts) {
    if (until.compareTo(lastFault) > 0) {
      lastFault = until;
    }
    disturbedUntil = disturbedUntil.compareTo(until) > 0 ? disturbedUntil : until;
    longestDisturbed = longestDisturbed.compareTo(lasts) > 0 ? longestDisturbed : lasts;
  }

  /** How much older than usual may be what a claim of now rests on. */
  private Duration slack(Duration now) {
    boolean disturbed = now.compareTo(disturbedUntil.plus(NEWS)) <= 0;
    return disturbed && longestDisturbed.compareTo(slowest) > 0 ? longestDisturbed : slowest;
  }

  boolean isTrueLately(Formula goal) {
    return lately(goal) != Truths.Grade.FALSE;
  }

  /** Whether somebody who is there surely measures the light that is to be held. */
  boolean canBeMeasured(Formula goal, Duration now) {
    return possibilities(now).isMeasured(goal);
  }

  /** What is to be held besides: nobody may end that for another goal. */
  void isToBeHeld(Formula condition) {
    held.add(condition);
  }

  Verdict of(Formula goal, Claim claim, Duration now) {
    return claim.reached() ? achieved(goal, claim, now) : failed(goal, claim, now);
  }

  /** Whether it was so at some moment of the last seconds. */
  Truths.Grade lately(Formula goal) {
    Formula spelled = new SpelledOut(site.home()).of(goal);
    return recent.stream()
        .map(moment -> new Truths(moment, site).of(spelled))
        .reduce(Truths.Grade.FALSE, Truths.Grade::or);
  }

  private Verdict achieved(Formula goal, Claim claim, Duration now) {
    recent.addLast(present.get());
    Formula bound = new Substitution(claim.binding()).apply(goal);
    return switch (lately(bound)) {
      case TRUE -> verdict(claim, Verdict.Kind.ACHIEVED, "");
      case CLOSE -> verdict(claim, Verdict.Kind.ACHIEVED_CLOSELY, "");
      case FALSE -> {
        Onlookers onlookers =
            new Onlookers(site, present.get(), possibilities(now), believed.get());
        boolean excused =
            !flawed.isEmpty()
                && !onlookers.couldTell(new SpelledOut(site.home()).of(bound))
                && (!claim.confirmed() || isOfBrokenSensors());
        yield excused
            ? verdict(claim, claim.confirmed() ? Verdict.Kind.MISLED : Verdict.Kind.UNSEEN, "")
            : verdict(
                claim,
                Verdict.Kind.FALSELY_ACHIEVED,
                "it is not so, nor was it in the last " + NEWS.toSeconds() + " s");
      }
    };
  }

  private boolean isOfBrokenSensors() {
    return Stream.of("LightSensor", "Camera")
        .flatMap(kind -> site.of(kind).stream())
        .anyMatch(flawed::contains);
  }

  private Verdict failed(Formula goal, Claim claim, Duration now) {
    List<Formula> wanted = new ArrayList<>(held);
    wanted.add(goal);
    if (!possibilities(now).canBe(spelled(wanted))) {
      return verdict(claim, Verdict.Kind.IMPOSSIBLE, "");
    }
    if (now.minus(lastFault).compareTo(NEWS.plus(slack(now))) < 0
        || site.isInhabited() && couldNotBeLately(wanted, now)) {
      return verdict(claim, Verdict.Kind.TOO_LATE_TO_KNOW, "");
    }
    if (claim.reasons().stream().anyMatch(reason -> isGivenUp(reason))) {
      return verdict(claim, Verdict.Kind.GAVE_UP, "");
    }
    return verdict(claim, Verdict.Kind.FALSELY_IMPOSSIBLE, "it can be done with " + usable(now));
  }

  /** Whether somebody stood in the way, or had the thing, a moment ago. */
  private boolean couldNotBeLately(List<Formula> wanted, Duration now) {
    Formula goal = spelled(wanted);
    return recent.stream()
        .anyMatch(moment -> !new Possibilities(site, moment, usable(now)).canBe(goal));
  }

  private Formula spelled(List<Formula> wanted) {
    return new SpelledOut(site.home()).of(new Formula.And(wanted));
  }

  private static boolean isGivenUp(String reason) {
    return reason.startsWith("No plan and no proof")
        || reason.startsWith("It was planned ")
        || reason.startsWith("It is given up, and not proven");
  }

  private Possibilities possibilities(Duration now) {
    return new Possibilities(site, present.get(), usable(now));
  }

  private Set<String> usable(Duration now) {
    Set<String> usable = new TreeSet<>(present.get().alive());
    usable.removeAll(cut);
    usable.removeAll(flawed);
    usable.removeIf(
        device ->
            changedAt.containsKey(device)
                && now.minus(changedAt.get(device)).compareTo(SETTLED.plus(slack(now))) < 0);
    return usable;
  }

  private static Verdict verdict(Claim claim, Verdict.Kind kind, String reason) {
    return new Verdict(claim.goal(), kind, claim.toString(), reason);
  }
}
