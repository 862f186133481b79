package org.maestro.members;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.UnaryOperator;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Result;
import org.maestro.sl.Term;

/**
 * Turns what happens to one call into one report, then lessons: a continuous feature is reported
 * when it is established, and each later observation teaches. The link tells it on the link's
 * thread; it works on the one of the given executor.
 */
public final class CallReporter implements RatsLink.CallListener {

  /** The listener to the course of one call. */
  public interface Listener {

    /** Exactly once: succeeded, established or failed. */
    void reported(Outcome outcome, ActionDispatcher.Report report);

    /** Each value set of a stream teaches, as the first did. */
    void learnt(Map<String, Term> outputs);

    /** The member says that it is at it still. */
    default void alive() {}

    /** Something that people should hear of at once. */
    default void alerted(String message) {}

    /** Another member could do it too. */
    default void offered(String by, Offer offer) {}

    /** The member gives it back; a report of its failure follows. */
    default void released(String reason) {}

    /** Nothing more will come. */
    void over();
  }

  private final Executor worker;
  private final UnaryOperator<String> understood;
  private final Listener listener;
  private boolean reported;

  /**
   * @param understood puts a fact that the member tells in the words that all use; on the worker
   */
  public CallReporter(Executor worker, UnaryOperator<String> understood, Listener listener) {
    this.worker = worker;
    this.understood = understood;
    this.listener = listener;
  }

  @Override
  public void progressed(Progress progress) {
    if (progress.kind() == Progress.Kind.ESTABLISHED) {
      worker.execute(() -> report(Outcome.SUCCEEDED, succeeded(progress.values())));
    } else if (progress.kind() == Progress.Kind.RUNNING) {
      worker.execute(listener::alive);
    }
  }

  @Override
  public void observed(Observation observation) {
    if (observation.feature().equals(ReservedFeature.ALERT)) {
      String message = String.valueOf(observation.values().get("message"));
      worker.execute(() -> listener.alerted(message));
    } else {
      worker.execute(() -> listener.learnt(JsonTerms.terms(observation.values())));
    }
  }

  @Override
  public void offered(String member, Offer offer) {
    worker.execute(
        () -> {
          if (!reported) {
            listener.offered(member, offer);
          }
        });
  }

  @Override
  public void released(String reason) {
    worker.execute(() -> listener.released(reason));
  }

  @Override
  public void ended(Result result) {
    worker.execute(
        () -> {
          report(
              result.outcome(),
              result.outcome() == Outcome.SUCCEEDED ? succeeded(result.values()) : failed(result));
          listener.over();
        });
  }

  private void report(Outcome outcome, ActionDispatcher.Report report) {
    if (!reported) {
      reported = true;
      listener.reported(outcome, report);
    }
  }

  private static ActionDispatcher.Report succeeded(Map<String, Object> values) {
    return new ActionDispatcher.Report(true, JsonTerms.terms(values), Optional.empty(), List.of());
  }

  private ActionDispatcher.Report failed(Result result) {
    List<FeatureRun.Learnt> refs = new ArrayList<>();
    for (RatsError.Reference ref : result.error().map(RatsError::refs).orElse(List.of())) {
      refs.add(
          new FeatureRun.Learnt(
              understood.apply(ref.fact()),
              JsonTerms.term(ref.have()),
              Optional.of(ref.need()).filter(need -> !need.isBlank())));
    }
    return new ActionDispatcher.Report(
        false,
        Map.of(),
        result
            .error()
            .map(RatsError::message)
            .or(() -> Optional.of(result.outcome().name().toLowerCase(Locale.ROOT))),
        new SaidFacts().readableReasons(result.from(), refs),
        result.error().map(RatsError::code).filter(CallReporter::isOfTheCallItself).isEmpty(),
        result.error().flatMap(CallReporter::refusal),
        result.error().map(RatsError::code).filter(ErrorCode.MEMBER_LOST::equals).isPresent());
  }

  /** Whether it says that the same again is refused again as long as things are as they are. */
  private static Optional<ActionDispatcher.Refusal> refusal(RatsError error) {
    return switch (error.code()) {
      case PRECONDITION_NOT_MET, INVALID_PARAMETERS, UNKNOWN_FEATURE, NOT_AUTHORISED ->
          Optional.of(
              error.retriable()
                  ? ActionDispatcher.Refusal.FOR_NOW
                  : ActionDispatcher.Refusal.AS_THINGS_ARE);
      default -> Optional.empty();
    };
  }

  /** Whether it says that the call as it stands could not be started. */
  private static boolean isOfTheCallItself(ErrorCode code) {
    return switch (code) {
      case MALFORMED,
          UNSUPPORTED_VERSION,
          UNKNOWN_FEATURE,
          INVALID_PARAMETERS,
          DISABLED,
          QUEUE_FULL,
          NOT_AUTHORISED ->
          true;
      default -> false;
    };
  }
}
