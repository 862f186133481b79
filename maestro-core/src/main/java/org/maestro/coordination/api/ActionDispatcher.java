package org.maestro.coordination.api;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.StepAccount;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Term;

/**
 * The agents at work, as coordination sees them. Reports come on the coordinator's thread, exactly
 * one for each order.
 */
public interface ActionDispatcher {

  Handle perform(Request order, Consumer<Report> reported);

  /**
   * Ends a call that a coordinator before this one has ordered and nobody wants any more; nobody
   * waits for its outcome. A crew that has no calls but its own has nothing to do.
   */
  default void callOff(String member, Call call) {}

  /**
   * Has the member say once more what it says of itself. A crew whose members say nothing has
   * nothing to do.
   *
   * @param heard is run once, on the coordinator's thread: what it says is known now, or it says
   *     nothing
   */
  default void ask(String member, Runnable heard) {
    heard.run();
  }

  /** The member says that it is at a step of the goal still, though it takes long. */
  default void alive(String goalId, String member, String feature) {}

  /**
   * Whether the same step has been ordered already, and its member has not said what became of it:
   * then to order it means to ask for that.
   */
  default boolean isOwed(String goalId, StepKey step) {
    return false;
  }

  /**
   * Orders of the goal of which nobody knows what became, as orders to end that; they are not owed
   * any more.
   *
   * @param unwanted steps that are not to be asked for any more
   */
  default List<Request> giveUpOwed(String goalId, Predicate<StepKey> unwanted) {
    return List.of();
  }

  /**
   * Stands in the queue for parts of a member that another manager has; said again, in the place of
   * what was said before. A crew that works for one manager only has nothing to do.
   */
  default void want(ComponentWant want) {}

  /** The goal wants nothing of the member any more that another manager has. */
  default void wantNoMore(String goalId, String member) {}

  /** Other managers may have these parts of the member from now on. */
  default void giveBack(String member, Set<String> components) {}

  /**
   * A step to be done now.
   *
   * @param call names it for good: ordered again, also by another coordinator, it is not done
   *     twice; empty: it is a new one each time
   * @param ends nothing is to be done: the call of that name is to end, if its member is at it, and
   *     what became of it to be reported
   */
  record Request(
      String goalId,
      Step step,
      Map<String, Argument> parameters,
      Duration timeout,
      Optional<Call> call,
      boolean ends) {

    public Request(
        String goalId,
        Step step,
        Map<String, Argument> parameters,
        Duration timeout,
        Optional<Call> call) {
      this(goalId, step, parameters, timeout, call, false);
    }

    public Request(String goalId, Step step, Map<String, Argument> parameters, Duration timeout) {
      this(goalId, step, parameters, timeout, Optional.empty());
    }

    public Request named(Call name) {
      return new Request(goalId, step, parameters, timeout, Optional.of(name));
    }

    public Request ending() {
      return new Request(goalId, step, parameters, timeout, call, true);
    }
  }

  /**
   * A call's name.
   *
   * @param life of the member, and the way in which it is called: once either is another, the
   *     member does not know the call, so it fails; empty: whatever they are
   */
  record Call(String id, Optional<String> life) {}

  /** A step under way, or a continuous feature that was established by it. */
  interface Handle {
    /** Ends it; a step still under way reports its end. */
    void cancel();

    /** When its member said the last time that it is at it still, by the clock. */
    default Optional<Duration> aliveAt() {
      return Optional.empty();
    }
  }

  /** The duration of a refusal: how long the same step would be refused again. */
  enum Refusal {
    /** As long as the facts are as they are that the step relies on. */
    AS_THINGS_ARE,
    /** The same, unless something passes by that no fact tells of, such as who stands in a way. */
    FOR_NOW
  }

  /**
   * The result of a step; for a continuous feature, that it is established.
   *
   * @param outputs empty unless it succeeded
   * @param problem one sentence unless it succeeded
   * @param refs facts that a failure teaches
   * @param begun false when the member did not even start, so that all is as it was
   * @param refusal the member says that it cannot be done as things are
   * @param unanswered nobody knows what became of it: the member has said nothing, and may be at it
   * @param account what the member said of itself around the step, if somebody has listened
   * @param heldBy another manager has what the step needs, so that it has its turn later
   */
  record Report(
      boolean succeeded,
      Map<String, Term> outputs,
      Optional<String> problem,
      List<FeatureRun.Learnt> refs,
      boolean begun,
      Optional<Refusal> refusal,
      boolean unanswered,
      Optional<StepAccount> account,
      Optional<HeldElsewhere> heldBy) {

    /** Not begun, as another manager has what the step needs. */
    public static Report held(HeldElsewhere by, String problem) {
      return new Report(
          false,
          Map.of(),
          Optional.of(problem),
          List.of(),
          false,
          Optional.empty(),
          false,
          Optional.empty(),
          Optional.of(by));
    }

    public Report(
        boolean succeeded,
        Map<String, Term> outputs,
        Optional<String> problem,
        List<FeatureRun.Learnt> refs,
        boolean begun) {
      this(succeeded, outputs, problem, refs, begun, Optional.empty(), false);
    }

    public Report(
        boolean succeeded,
        Map<String, Term> outputs,
        Optional<String> problem,
        List<FeatureRun.Learnt> refs,
        boolean begun,
        Optional<Refusal> refusal,
        boolean unanswered) {
      this(
          succeeded,
          outputs,
          problem,
          refs,
          begun,
          refusal,
          unanswered,
          Optional.empty(),
          Optional.empty());
    }

    public Report(
        boolean succeeded,
        Map<String, Term> outputs,
        Optional<String> problem,
        List<FeatureRun.Learnt> refs) {
      this(succeeded, outputs, problem, refs, true);
    }

    public Report with(Optional<String> why, List<FeatureRun.Learnt> reasons) {
      return new Report(
          succeeded, outputs, why, reasons, begun, refusal, unanswered, account, heldBy);
    }

    public Report with(Optional<StepAccount> told) {
      return new Report(
          succeeded, outputs, problem, refs, begun, refusal, unanswered, told, heldBy);
    }
  }
}
