package org.maestro.rats.member;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The tasks that run and those that wait on a member. A task starts when neither a running one nor
 * one that has waited longer needs a component of its (Three-layered architecture, 3.2.1; M38-M40).
 * Clock thread only.
 */
final class TaskQueue implements Task.Keeper {

  private static final Logger LOG = LoggerFactory.getLogger(TaskQueue.class);
  private static final int MOST_WAITING = 64;

  private final String member;
  private final MemberPublisher voice;
  private final MemberCondition condition;
  private final CallAnswers answers;
  private final Runnable conditionChanged;
  private final Runnable conditionChanging;
  private final Clock clock;
  private final StateRules rules;
  private final List<Task> waiting = new ArrayList<>();
  private final List<Task> running = new ArrayList<>();
  private final Map<Task, StreamOutlet> streams = new HashMap<>();
  private boolean starting;
  private int becomingSafe;

  TaskQueue(
      MemberProfile profile,
      MemberPublisher voice,
      MemberCondition condition,
      CallAnswers answers,
      Runnable conditionChanged,
      Runnable conditionChanging,
      Clock clock) {
    this.member = profile.id();
    this.rules = profile.rules();
    this.voice = voice;
    this.condition = condition;
    this.answers = answers;
    this.conditionChanged = conditionChanged;
    this.conditionChanging = conditionChanging;
    this.clock = clock;
  }

  boolean full() {
    return waiting.size() >= MOST_WAITING;
  }

  void add(Call call, MemberProfile.Feature feature, Duration limit) {
    Task task = new Task(call, feature, limit, clock, member, this);
    progressed(task, Progress.Kind.ACCEPTED, 0, Map.of());
    waiting.add(task);
    startWhatCan();
    if (waiting.contains(task)) {
      changing();
    }
  }

  boolean isIdle() {
    return waiting.isEmpty() && running.isEmpty();
  }

  /** Ends what its caller may not call any more. */
  void stopForbidden(Predicate<Call> allowed) {
    for (Task task : all()) {
      Call call = task.call();
      if (!allowed.test(call)) {
        String message =
            "The rules of the site do not let %s call %s of %s any more"
                .formatted(call.from(), call.feature(), member);
        task.stop(
            Outcome.CANCELED, Optional.of(CallAnswers.error(ErrorCode.NOT_AUTHORISED, message)));
      }
    }
  }

  /** Whether a call of the feature would begin at once. */
  boolean couldBegin(MemberProfile.Feature feature) {
    return !becomesSafe()
        && all().stream()
            .noneMatch(
                task -> task.feature().occupies().stream().anyMatch(feature.occupies()::contains));
  }

  /**
   * The caller asks for a call that waits or runs, perhaps after a life of its own ended: it is
   * told how far the call is.
   */
  void tellAgain(Call call) {
    all().stream()
        .filter(task -> task.call().isAgain(call))
        .findFirst()
        .ifPresent(
            task -> {
              task.tellAgain();
              tellWhatIsOwed(task);
            });
  }

  /**
   * Cancels a call; false when none of that id waits or runs. Ids are unique for each caller only:
   * who cancels means a call of its own, if it has one of that id.
   *
   * @param others whether it may also end calls that it did not make
   */
  boolean cancel(String caller, String callId, boolean others) {
    List<Task> named =
        all().stream().filter(candidate -> candidate.call().id().equals(callId)).toList();
    Optional<Task> task =
        named.stream()
            .filter(candidate -> candidate.call().from().equals(caller))
            .findFirst()
            .or(() -> named.stream().filter(candidate -> others).findFirst());
    task.ifPresent(found -> found.stop(Outcome.CANCELED, canceled("The call was cancelled")));
    return task.isPresent();
  }

  /**
   * Cancels everything; the action runs when all of it has ended and the member rests in a safe
   * state (Three-layered architecture, 3.2.1; M37).
   */
  void makeSafe(Runnable action) {
    becomingSafe++;
    List<Task> all = all();
    List<Task> left = new ArrayList<>(all);
    all.forEach(
        task ->
            task.afterEnd(
                () -> {
                  left.remove(task);
                  if (left.isEmpty()) {
                    rest(action);
                  }
                }));
    all.forEach(task -> task.stop(Outcome.CANCELED, canceled("The member was told to be safe")));
    if (all.isEmpty()) {
      rest(action);
    }
  }

  /** Whether it ends what runs, so that nothing may start. */
  boolean becomesSafe() {
    return becomingSafe > 0;
  }

  /**
   * Nobody is left who could end what the controller keeps going: it ends now. Tasks that end by
   * themselves may, and the member rests in a safe state when nothing runs any more.
   */
  void abandonedBy(String controller) {
    List<Task> own = all().stream().filter(task -> task.call().from().equals(controller)).toList();
    own.stream()
        .filter(Task::continuous)
        .forEach(
            task ->
                task.stop(Outcome.CANCELED, canceled("The controller " + controller + " is lost")));
    List<Task> left = new ArrayList<>(own);
    own.forEach(
        task ->
            task.afterEnd(
                () -> {
                  left.remove(task);
                  if (left.isEmpty()) {
                    restWhenIdle();
                  }
                }));
    if (own.isEmpty()) {
      restWhenIdle();
    }
  }

  private void restWhenIdle() {
    if (running.isEmpty() && waiting.isEmpty()) {
      condition.restSafely();
      changed();
    }
  }

  private void rest(Runnable action) {
    becomingSafe--;
    condition.restSafely();
    changed();
    action.run();
  }

  private List<Task> all() {
    List<Task> all = new ArrayList<>(waiting);
    all.addAll(running);
    return all;
  }

  private void startWhatCan() {
    if (starting || becomesSafe()) {
      return;
    }
    starting = true;
    try {
      Optional<Task> next = startable();
      while (next.isPresent()) {
        start(next.get());
        next = startable();
      }
    } finally {
      starting = false;
    }
  }

  private Optional<Task> startable() {
    Set<String> taken = new HashSet<>();
    running.forEach(task -> taken.addAll(task.feature().occupies()));
    for (Task task : waiting) {
      if (task.feature().occupies().stream().noneMatch(taken::contains)) {
        return Optional.of(task);
      }
      taken.addAll(task.feature().occupies());
    }
    return Optional.empty();
  }

  private void start(Task task) {
    waiting.remove(task);
    running.add(task);
    endWhatThisEnds(task);
    changing();
    task.start();
  }

  private void endWhatThisEnds(Task ending) {
    for (Task task : List.copyOf(running)) {
      boolean ended =
          task.feature().endedBy().filter(ending.feature().id()::equals).isPresent()
              && ending.feature().required().stream()
                  .allMatch(name -> sameArgument(name, ending.call(), task.call()));
      if (ended) {
        task.stop(Outcome.SUCCEEDED, Optional.empty());
      }
    }
  }

  /** Pointers are the same when they point at the same thing, whatever properties they carry. */
  private static boolean sameArgument(String name, Call one, Call other) {
    return Objects.equals(
        identity(one.parameters().get(name)), identity(other.parameters().get(name)));
  }

  private static @Nullable Object identity(@Nullable Object argument) {
    return argument instanceof Map<?, ?> map && map.get("ref") != null ? map.get("ref") : argument;
  }

  private static Optional<RatsError> canceled(String message) {
    return Optional.of(CallAnswers.error(ErrorCode.CANCELED, message));
  }

  /** To be told unless it is over in the same moment. */
  private void changing() {
    condition.tasks(running, waiting);
    conditionChanging.run();
  }

  private void changed() {
    condition.tasks(running, waiting);
    conditionChanged.run();
  }

  @Override
  public void progressed(
      Task task, Progress.Kind kind, double fraction, Map<String, Object> values) {
    boolean untilAnswered = kind == Progress.Kind.ACCEPTED || kind == Progress.Kind.STARTED;
    task.owe(new Progress(task.call().id(), member, kind, fraction, values));
    if (untilAnswered) {
      clock.schedule(Duration.ZERO, member, () -> tellWhatIsOwed(task));
    } else {
      tellWhatIsOwed(task);
    }
  }

  /** What is answered at once needs no sign of life before. */
  private void tellWhatIsOwed(Task task) {
    task.takeOwed().forEach(sign -> voice.progress(task.call().from(), sign));
  }

  @Override
  public void observed(Task task, Map<String, Object> values) {
    voice.observation(new Observation(task.call().id(), member, task.feature().id(), values));
  }

  @Override
  public void streamed(Task task, StreamFrame frame) {
    streams.computeIfAbsent(task, started -> new StreamOutlet(voice::frame)).add(frame);
  }

  @Override
  public void givenBack(Task task, String reason) {
    voice.release(task.call(), reason);
  }

  @Override
  public void exitFailed(Task task, String message) {
    rules
        .lastResort()
        .ifPresentOrElse(
            resort -> {
              condition.forced(resort.state());
              force(resort);
            },
            condition::restSafely);
    String alert = message + "; it rests in the state " + condition.atRest();
    LOG.error("{}: {}", member, alert);
    voice.alert(task.call().id(), alert);
  }

  private void force(StateRules.LastResort resort) {
    try {
      resort.action().run();
    } catch (RuntimeException fault) {
      LOG.error("The last resort of {} failed too", member, fault);
    }
  }

  @Override
  public void ended(
      Task task, Outcome outcome, Map<String, Object> values, Optional<RatsError> error) {
    waiting.remove(task);
    boolean ran = running.remove(task);
    Optional.ofNullable(streams.remove(task)).ifPresent(StreamOutlet::end);
    if (ran && task.wentOut() && outcome != Outcome.SUCCEEDED) {
      condition.restSafely();
    }
    condition.ended(task.call().id(), outcome);
    changed();
    answers.answer(task.call(), outcome, values, error);
    startWhatCan();
  }

  @Override
  public boolean gone() {
    return voice.silent();
  }
}
