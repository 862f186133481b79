package org.maestro.rats.link;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.time.Clock;

/**
 * Statements about themselves that members still owe although they are there, or should be: they
 * are asked again, later and later, until these are heard. A broker may lose a retained message to
 * a subscriber that comes at the very moment of its publication (seen with Artemis), and a question
 * may get lost or be answered too late. Clock thread only.
 */
final class MissingWords {

  /** Wall time after a connect, or the first sign of a member, until it is asked. */
  static final Duration FIRST_WAIT = Duration.ofMillis(500);

  /** Wall time. */
  private static final Duration LONGEST_WAIT = Duration.ofMinutes(1);

  /** Of who was never heard of, or is said to be gone: it may not be there at all. */
  private static final int MOST_QUESTIONS_TO_STRANGERS = 8;

  /** The ways to ask members for what is missing. */
  interface Questions {
    /** The member is to describe itself. */
    void ask(String member);

    /** For those of whom nothing was heard, and who therefore cannot be asked. */
    void lookForStrangers();
  }

  /** The extent of what is known of a member. */
  enum Known {
    NOTHING,
    A_PART,
    ENOUGH
  }

  /** The records of what is known of each member. */
  interface Records {
    Known of(String member);
  }

  private final String owner;
  private final Records records;
  private final Questions questions;
  private final Clock clock;
  private final Map<String, Clock.Timer> asking = new HashMap<>();
  private Optional<Clock.Timer> nextLook = Optional.empty();
  private boolean ended;

  MissingWords(String owner, Records records, Questions questions, Clock clock) {
    this.owner = owner;
    this.records = records;
    this.questions = questions;
    this.clock = clock;
  }

  /** There is a new connection: looks for strangers some times, for two minutes in all. */
  void lookForStrangers() {
    look(1);
  }

  private void look(int number) {
    nextLook.ifPresent(Clock.Timer::cancel);
    if (!ended && number <= MOST_QUESTIONS_TO_STRANGERS) {
      nextLook =
          Optional.of(
              clock.schedule(
                  wait(number),
                  owner,
                  () -> {
                    questions.lookForStrangers();
                    look(number + 1);
                  }));
    }
  }

  void end() {
    ended = true;
    nextLook.ifPresent(Clock.Timer::cancel);
  }

  /** There was a sign of the member, or there should be one. */
  void expect(String member) {
    if (records.of(member) == Known.ENOUGH) {
      Optional.ofNullable(asking.remove(member)).ifPresent(Clock.Timer::cancel);
    } else if (!asking.containsKey(member)) {
      later(member, 0);
    }
  }

  private void later(String member, int before) {
    Clock.Timer timer = clock.schedule(wait(before), owner, () -> due(member, before));
    asking.put(member, timer);
  }

  private void due(String member, int before) {
    asking.remove(member);
    Known known = records.of(member);
    boolean givenUp = known == Known.NOTHING && before >= MOST_QUESTIONS_TO_STRANGERS;
    if (known != Known.ENOUGH && !givenUp && !ended) {
      questions.ask(member);
      later(member, before + 1);
    }
  }

  /** How long to wait after so many questions, in simulated time. */
  private Duration wait(int number) {
    Duration longer = FIRST_WAIT.multipliedBy(1L << Math.min(number, Byte.SIZE));
    Duration wall = longer.compareTo(LONGEST_WAIT) < 0 ? longer : LONGEST_WAIT;
    return clock.ofWall(wall);
  }
}
