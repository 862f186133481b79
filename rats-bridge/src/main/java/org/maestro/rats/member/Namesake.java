package org.maestro.rats.member;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Transport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Statements in this member's name: by itself, by its will, or by another that calls itself by its
 * id (Three-layered architecture, 2; M9).
 *
 * <p>Of two of one id the one that started later has to go. On an open site anybody may say that
 * there is another, so the later one asks the other life first. If that answers, it goes; it looks
 * again from time to time, and comes back when nobody answers any more. Clock thread only, but for
 * {@link #isAway}.
 */
final class Namesake {

  private static final Logger LOG = LoggerFactory.getLogger(Namesake.class);

  /**
   * Wall time in which the other life answers. Where both have one client id the broker lets only
   * one of them in at a time; the other is back within this time.
   */
  private static final Duration ANSWER_LIMIT = Duration.ofSeconds(3);

  /** Wall time until it looks again for the first time; each time it takes twice as long. */
  private static final Duration FIRST_ABSENCE = Duration.ofSeconds(30);

  private static final Duration LONGEST_ABSENCE = Duration.ofMinutes(10);

  /** Simulated time between two descriptions, however often another one is told. */
  private static final Duration BETWEEN_DESCRIPTIONS = Duration.ofSeconds(1);

  /** The listener for what becomes of the member. */
  interface Watcher {
    /** The status that stands on the bus is not the member's: it has to say that it is there. */
    void contradicted();

    /** Somebody cleared it: what is retained besides may be gone too. */
    void cleared();

    /** The description that stands on the bus is not the member's. */
    void misdescribed();

    /** The member is off the bus for a while. */
    void left();

    /** Nobody else is there: the member tells all of itself. */
    void stays();
  }

  private final String id;
  private final String boot;
  private final MemberPublisher voice;
  private final Transport transport;
  private final Complaints complaints;
  private final Watcher watcher;
  private final Clock clock;
  private final WireFormat wire = new WireFormat();
  private OtherLives others;
  private Optional<Question> open = Optional.empty();
  private Optional<String> leftFor = Optional.empty();
  private Duration absence = FIRST_ABSENCE;
  private Duration nextDescription = Duration.ZERO;
  private boolean isToDescribe;
  private volatile boolean away;

  Namesake(
      String id,
      String boot,
      MemberPublisher voice,
      Transport transport,
      Complaints complaints,
      Watcher watcher,
      Clock clock) {
    this.id = id;
    this.boot = boot;
    this.voice = voice;
    this.transport = transport;
    this.complaints = complaints;
    this.watcher = watcher;
    this.clock = clock;
    this.others = new OtherLives(boot);
  }

  /** Whether the member has left because the other one answers. Any thread. */
  boolean isAway() {
    return away;
  }

  /** Whether calls for that life of the id may have somebody else who answers them. */
  boolean mayBe(String otherBoot) {
    return open.filter(question -> question.boot.equals(otherBoot)).isPresent();
  }

  /**
   * A will that came late, of this life or a former one, must not stay the last word; nor what
   * another clears, such as a second member of this id that leaves for good.
   */
  void statusHeard(Message message) {
    if (message.payload().length == 0) {
      if (others.heardItself()) {
        watcher.cleared();
      }
      return;
    }
    try {
      statusHeard(wire.decodeStatus(message.payload()));
    } catch (MalformedMessageException malformed) {
      if (complaints.isDue(id)) {
        LOG.warn(
            "{} found a status of its own that it cannot read: {}", id, malformed.getMessage());
      }
      watcher.contradicted();
    }
  }

  /** Who reads another's would take the member for what it is not, or for nothing. */
  void descriptionHeard(Message message) {
    if (voice.isDescription(message.payload()) || isToDescribe) {
      return;
    }
    isToDescribe = true;
    clock.schedule(
        nextDescription.minus(clock.now()),
        id,
        () -> {
          isToDescribe = false;
          nextDescription = clock.now().plus(BETWEEN_DESCRIPTIONS);
          watcher.misdescribed();
        });
  }

  private void statusHeard(MemberStatus status) {
    boolean other = others.isAlive(status);
    if (other && boot.compareTo(status.boot()) > 0) {
      if (open.isEmpty()) {
        ask(status.boot());
      }
    } else if (other || !isPresent(status)) {
      watcher.contradicted();
    }
  }

  /** Whether who hears it takes the member for one that is there, or soon will be. */
  private boolean isPresent(MemberStatus status) {
    return switch (status.phase()) {
      case READY -> true;
      case INIT -> !others.heardItself();
      case DISCONNECTED, LOST -> false;
    };
  }

  /** The member may not tell of itself yet when it was away: it looks first. */
  boolean looksFirst() {
    leftFor.ifPresent(this::ask);
    return leftFor.isPresent();
  }

  /**
   * The connection is lost. Who loses it while it asks has lost it to the other, who took its place
   * with the broker, or will soon know better.
   */
  void dropped() {
    others.dropped();
    open.ifPresent(this::leave);
  }

  void answered(Message message) {
    try {
      Result result = wire.decodeResult(message.payload());
      boolean ownRefusal =
          result.error().map(RatsError::code).filter(ErrorCode.RESTARTED::equals).isPresent();
      open.filter(question -> question.callId.equals(result.id()) && !ownRefusal)
          .ifPresent(this::leave);
    } catch (MalformedMessageException malformed) {
      LOG.debug("{} heard a malformed result: {}", id, malformed.getMessage());
    }
  }

  private void ask(String otherBoot) {
    Call ping =
        new Call(
            voice.nextCallId(),
            Optional.of(id),
            Optional.of(otherBoot),
            ReservedFeature.PING.word(),
            Map.of(),
            clock.ofWall(ANSWER_LIMIT),
            id,
            Optional.empty());
    Question question =
        new Question(
            otherBoot,
            ping.id(),
            clock.schedule(clock.ofWall(ANSWER_LIMIT), id, () -> unanswered(otherBoot)));
    open = Optional.of(question);
    voice.call(ping);
  }

  private void unanswered(String otherBoot) {
    open = Optional.empty();
    if (away) {
      LOG.warn("{} is back: the other of its id gives no answer any more", id);
    } else {
      LOG.warn("{} stays: nobody answers for the life {} that was said to be its", id, otherBoot);
    }
    away = false;
    leftFor = Optional.empty();
    absence = FIRST_ABSENCE;
    watcher.stays();
  }

  private void leave(Question question) {
    question.timer.cancel();
    open = Optional.empty();
    if (!away) {
      LOG.error(
          "There is a member {} already; this one leaves, give it an id of its own. It comes back"
              + " when that one is gone.",
          id);
    }
    away = true;
    leftFor = Optional.of(question.boot);
    others = new OtherLives(boot);
    watcher.left();
    transport.stayAway(absence);
    Duration twice = absence.multipliedBy(2);
    absence = twice.compareTo(LONGEST_ABSENCE) < 0 ? twice : LONGEST_ABSENCE;
  }

  private record Question(String boot, String callId, Clock.Timer timer) {}
}
