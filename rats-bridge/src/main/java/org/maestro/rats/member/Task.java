package org.maestro.rats.member;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One call from its acceptance to its one outcome: waiting, running, perhaps on its way out, ended.
 * Clock thread only.
 */
final class Task implements Execution {

  private static final Logger LOG = LoggerFactory.getLogger(Task.class);

  /** Simulated time that an exit strategy may take before the call is answered without it. */
  static final Duration EXIT_LIMIT = Duration.ofSeconds(60);

  private enum Phase {
    WAITING,
    RUNNING,
    EXITING,
    ENDED
  }

  /** The listener for what becomes of a task. */
  interface Keeper {
    void progressed(Task task, Progress.Kind kind, double fraction, Map<String, Object> values);

    void observed(Task task, Map<String, Object> values);

    void streamed(Task task, StreamFrame frame);

    /** It is given back, and on its way out. */
    void givenBack(Task task, String reason);

    /** Its exit strategy did not bring the device to a safe state. */
    void exitFailed(Task task, String message);

    void ended(Task task, Outcome outcome, Map<String, Object> values, Optional<RatsError> error);

    /** The member is gone: nothing counts any more. */
    boolean gone();
  }

  private final Call call;
  private final MemberProfile.Feature feature;
  private final Clock clock;
  private final String owner;
  private final Keeper keeper;
  private final Clock.Timer timeout;
  private final List<Runnable> afterEnd = new ArrayList<>();
  private Optional<Clock.Timer> exitLimit = Optional.empty();
  private Phase phase = Phase.WAITING;
  private final List<Progress> owed = new ArrayList<>();
  private boolean established;
  private boolean wentOut;
  private Duration nextObservation = Duration.ZERO;
  private long frames;
  private Map<String, Object> latestValues = Map.of();
  private ExitStrategy strategy = Runnable::run;

  /**
   * @param limit simulated time for queueing and execution (Three-layered architecture, 3.2.3; M59)
   */
  Task(
      Call call,
      MemberProfile.Feature feature,
      Duration limit,
      Clock clock,
      String owner,
      Keeper keeper) {
    this.call = call;
    this.feature = feature;
    this.clock = clock;
    this.owner = owner;
    this.keeper = keeper;
    this.timeout = clock.schedule(limit, owner, this::timedOut);
  }

  @Override
  public Call call() {
    return call;
  }

  MemberProfile.Feature feature() {
    return feature;
  }

  void start() {
    phase = Phase.RUNNING;
    keeper.progressed(this, Progress.Kind.STARTED, 0, Map.of());
    try {
      feature.procedure().start(this);
    } catch (RuntimeException fault) {
      LOG.error("The procedure of {} of {} failed", feature.id(), owner, fault);
      fail(
          new RatsError(
              ErrorCode.INTERNAL,
              RatsError.Level.ERROR,
              "The procedure of " + feature.id() + " broke off: " + fault.getMessage(),
              Optional.empty(),
              List.of(),
              false));
    }
  }

  /**
   * Ends it from outside: at once while it waits, through its exit strategy when it runs
   * (Three-layered architecture, 3.2.1; M41, M42, M45).
   */
  void stop(Outcome outcome, Optional<RatsError> error) {
    if (phase == Phase.WAITING) {
      end(outcome, Map.of(), error);
    } else if (phase == Phase.RUNNING) {
      phase = Phase.EXITING;
      wentOut = true;
      exitLimit = Optional.of(clock.schedule(EXIT_LIMIT, owner, () -> exitTookTooLong(outcome)));
      try {
        strategy.exit(() -> end(outcome, Map.of(), error));
      } catch (RuntimeException fault) {
        LOG.error("The exit strategy of {} of {} failed", feature.id(), owner, fault);
        exitFailed(
            outcome, "The exit strategy of " + feature.id() + " broke off: " + fault.getMessage());
      }
    }
  }

  /** A sign of life that its caller is still to be told. */
  void owe(Progress sign) {
    owed.add(sign);
  }

  /** Nothing once it has ended. */
  List<Progress> takeOwed() {
    List<Progress> taken = phase == Phase.ENDED ? List.of() : List.copyOf(owed);
    owed.clear();
    return taken;
  }

  boolean continuous() {
    return feature.continuous();
  }

  /** Whether it was ended through its exit strategy. */
  boolean wentOut() {
    return wentOut;
  }

  /** Tells how far it is, with the latest values of a stream; on its way out its end is near. */
  void tellAgain() {
    if (phase == Phase.WAITING) {
      keeper.progressed(this, Progress.Kind.ACCEPTED, 0, Map.of());
    } else if (phase == Phase.RUNNING && established) {
      keeper.progressed(this, Progress.Kind.ESTABLISHED, 0, latestValues);
    } else if (phase == Phase.RUNNING) {
      keeper.progressed(this, Progress.Kind.STARTED, 0, Map.of());
    }
  }

  /** Runs the action once the task has ended, at once if it has. */
  void afterEnd(Runnable action) {
    if (phase == Phase.ENDED) {
      action.run();
    } else {
      afterEnd.add(action);
    }
  }

  @Override
  public void established(Map<String, Object> values) {
    if (phase == Phase.RUNNING && feature.continuous() && !established) {
      established = true;
      latestValues = values;
      timeout.cancel();
      keeper.progressed(this, Progress.Kind.ESTABLISHED, 0, values);
    }
  }

  @Override
  public void observed(Map<String, Object> values) {
    if (phase == Phase.RUNNING && established && !keeper.gone()) {
      latestValues = values;
      if (clock.now().compareTo(nextObservation) < 0) {
        return;
      }
      nextObservation = clock.now().plus(feature.frequency().period(call.parameters()));
      keeper.observed(this, values);
    }
  }

  @Override
  public void streamed(Duration capturedAt, String mediaType, byte[] data) {
    if (phase == Phase.RUNNING && established && !keeper.gone()) {
      frames++;
      keeper.streamed(
          this,
          new StreamFrame(
              call.id(),
              owner,
              feature.id(),
              frames,
              clock.start().plus(capturedAt),
              mediaType,
              data));
    }
  }

  @Override
  public void observeRegularly(Reading reading) {
    established(reading.values());
    observeNext(reading, feature.frequency().period(call.parameters()));
  }

  private void observeNext(Reading reading, Duration period) {
    clock.schedule(
        period,
        owner,
        () -> {
          if (!ended()) {
            observed(reading.values());
            observeNext(reading, period);
          }
        });
  }

  @Override
  public void giveBack(RatsError reason) {
    if (phase == Phase.RUNNING) {
      keeper.givenBack(this, reason.message());
      stop(Outcome.FAILED, Optional.of(reason));
    }
  }

  @Override
  public void progress(double fraction) {
    if (phase == Phase.RUNNING) {
      keeper.progressed(this, Progress.Kind.RUNNING, Math.min(1, Math.max(0, fraction)), Map.of());
    }
  }

  @Override
  public void succeed(Map<String, Object> values) {
    if (phase == Phase.RUNNING) {
      end(Outcome.SUCCEEDED, values, Optional.empty());
    }
  }

  @Override
  public void fail(RatsError error) {
    if (phase == Phase.RUNNING) {
      end(Outcome.FAILED, Map.of(), Optional.of(error));
    }
  }

  @Override
  public void onCancel(ExitStrategy exit) {
    strategy = exit;
  }

  @Override
  public boolean ended() {
    return phase == Phase.EXITING || phase == Phase.ENDED || keeper.gone();
  }

  private void timedOut() {
    String where = phase == Phase.WAITING ? "while it waited" : "while it ran";
    String message = "The " + call.timeout().toMillis() + " ms of the call passed " + where;
    stop(Outcome.TIMED_OUT, Optional.of(CallAnswers.error(ErrorCode.TIMEOUT, message)));
  }

  private void exitTookTooLong(Outcome outcome) {
    exitFailed(
        outcome,
        "The exit strategy of %s did not end within %d s"
            .formatted(feature.id(), EXIT_LIMIT.toSeconds()));
  }

  private void exitFailed(Outcome outcome, String message) {
    if (phase == Phase.EXITING) {
      keeper.exitFailed(this, message);
      RatsError error =
          new RatsError(
              ErrorCode.HARDWARE_FAILURE,
              RatsError.Level.ERROR,
              message,
              Optional.empty(),
              List.of(),
              false);
      end(outcome == Outcome.SUCCEEDED ? Outcome.FAILED : outcome, Map.of(), Optional.of(error));
    }
  }

  private void end(Outcome outcome, Map<String, Object> values, Optional<RatsError> error) {
    if (phase != Phase.ENDED) {
      phase = Phase.ENDED;
      timeout.cancel();
      exitLimit.ifPresent(Clock.Timer::cancel);
      keeper.ended(this, outcome, values, error);
      List.copyOf(afterEnd).forEach(Runnable::run);
    }
  }
}
