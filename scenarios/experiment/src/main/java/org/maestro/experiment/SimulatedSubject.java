package org.maestro.experiment;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.experiment.running.Conversation;

/**
 * A program in the place of the paper's subjects, which has only what a person would have: it says
 * words, waits for what is done, and hears what is said. It climbs by readings: straight on while
 * they grow, else to a side, or back. It errs: it says left for right, and takes a weaker reading
 * for a stronger one. How long it thinks before it says something, and that it thinks for less time
 * once it has heard a stressed voice, is assumed; it says nothing of people. For one thread.
 */
final class SimulatedSubject {
  /** The voice that makes it think shorter. */
  static final String STRESSED = "stressed";

  /** Below this it has the robot go on until it says stop. */
  private static final int FAR_AWAY = 30;

  private static final Duration LONG_ENOUGH = Duration.ofSeconds(4);
  private static final Duration PATIENCE = Duration.ofSeconds(90);
  private static final String EMPTY = "My battery is empty.";
  private static final String BLOCKED = "Something is in my way.";
  private static final Pattern READING = Pattern.compile("The signal is (\\d+)\\.");

  private final Conversation talk;
  private final Manner manner;
  private final SplittableRandom chance;
  private final List<Integer> readings = new ArrayList<>();

  /**
   * Its manner.
   *
   * @param leastSeconds before anything is said
   * @param meanSeconds before anything is said, in the mean; what is beyond the least is
   *     exponentially distributed
   * @param errors share of turns, and of comparisons, in which it errs
   * @param kappa share by which it thinks shorter once it has heard a stressed voice
   * @param enough what it was told before: with so strong a signal data can be sent
   */
  record Manner(
      double leastSeconds, double meanSeconds, double errors, double kappa, double enough) {}

  SimulatedSubject(Conversation talk, Manner manner, SplittableRandom chance) {
    this.talk = talk;
    this.manner = manner;
    this.chance = chance;
  }

  /** All readings that it has heard, in order. */
  List<Integer> readings() {
    return List.copyOf(readings);
  }

  /** The direction in which it has the robot go, as it remembers it. */
  private enum Course {
    /** To a side of the one before. */
    NEW,
    /** The signal has grown since. */
    RISING,
    /** It did not grow, and the robot was turned around. */
    BACK
  }

  /** Goes on until the data is sent, or the battery is empty. */
  void explore() {
    int last = read().orElse(0);
    Course course = Course.NEW;
    while (!isOver()) {
      if (last >= manner.enough() && transmit()) {
        return;
      }
      boolean isFree = last < FAR_AWAY ? goFar() : goSomeWay();
      int now = read().orElse(last);
      boolean grows = (now > last) != errs();
      if (now >= manner.enough() || isFree && grows) {
        course = Course.RISING;
      } else if (isFree && course == Course.NEW) {
        say("turn around");
        course = Course.BACK;
      } else {
        turnAside();
        course = Course.NEW;
      }
      last = now;
    }
  }

  private boolean errs() {
    return chance.nextDouble() < manner.errors();
  }

  private OptionalInt read() {
    int before = talk.heard().size();
    say(readings.size() % 2 == 0 ? "take a reading" : "what is the signal?");
    OptionalInt reading =
        talk.heard().stream()
            .skip(before)
            .map(heard -> READING.matcher(heard.text()))
            .filter(Matcher::matches)
            .mapToInt(words -> Integer.parseInt(words.group(1)))
            .reduce((one, other) -> other);
    reading.ifPresent(readings::add);
    return reading;
  }

  private boolean transmit() {
    return !isOver() && say("transmit").isDone();
  }

  /** Whether nothing was in the way. */
  private boolean goSomeWay() {
    int before = talk.heard().size();
    say("go forward two metres");
    return !wasBlocked(before);
  }

  /** The same, for as far as it goes until it is told to stop. */
  private boolean goFar() {
    int before = talk.heard().size();
    think();
    if (isOver()) {
      return true;
    }
    Conversation.Said going = talk.say("go straight");
    talk.listen(() -> going.isOver() || isOver(), LONG_ENOUGH);
    if (!going.isOver()) {
      say("stop");
      talk.listen(() -> going.isOver() || isOver(), PATIENCE);
    }
    return !wasBlocked(before);
  }

  private boolean wasBlocked(int before) {
    return talk.heard().stream().skip(before).anyMatch(heard -> heard.text().equals(BLOCKED));
  }

  /** To a side that it has no reason to prefer; at times it says the other one than it means. */
  private void turnAside() {
    boolean left = chance.nextBoolean() != errs();
    say(left ? "turn left" : "turn right");
  }

  /** Thinks, says it, and waits for what comes of it. */
  private Conversation.Said say(String words) {
    think();
    Conversation.Said said = talk.say(words);
    talk.listen(() -> said.isOver() || isOver(), PATIENCE);
    return said;
  }

  private void think() {
    double seconds =
        manner.leastSeconds()
            - (manner.meanSeconds() - manner.leastSeconds()) * Math.log(1 - chance.nextDouble());
    double share = hearsStress() ? 1 - manner.kappa() : 1;
    talk.listen(this::isOver, Duration.ofMillis(Math.round(1000 * share * seconds)));
  }

  private boolean hearsStress() {
    List<Conversation.Heard> heard = talk.heard();
    return heard.stream().anyMatch(one -> one.voice().equals(STRESSED));
  }

  private boolean isOver() {
    return talk.heard().stream().anyMatch(heard -> heard.text().equals(EMPTY));
  }
}
