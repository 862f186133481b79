package org.maestro.coordination.story;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.maestro.coordination.api.BidRecord;
import org.maestro.coordination.api.PlanRecord;
import org.maestro.coordination.api.ScriptStep;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.api.StepRecord;
import org.maestro.coordination.api.StepRecord.State;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.rats.time.Clock;

/**
 * The latest plans of one goal or the steps of its script, and what became of them: the story as
 * data. As many are kept as there is room for, and none beyond the end of the process. The
 * coordinator's thread only.
 */
public final class PlanRecords {
  private static final int MOST = 20;
  private static final long MOST_BYTES = 256 << 10;
  private static final long BYTES_OF_A_STEP = 512;
  private static final long BYTES_OF_A_BID = 160;

  private final Clock clock;
  private final List<PlanRecord> records = new ArrayList<>();
  private Supplier<List<ScriptStep>> script = List::of;

  public PlanRecords(Clock clock) {
    this.clock = clock;
  }

  /** Oldest first. */
  public List<PlanRecord> all() {
    return List.copyOf(records);
  }

  /** From now on the steps of a script are told with them. */
  public void follow(Supplier<List<ScriptStep>> steps) {
    script = steps;
  }

  /** The steps of the script, where the goal is one that is carried out; else none. */
  public List<ScriptStep> ofScript() {
    return script.get();
  }

  /** What they take of memory, about. */
  public long bytes() {
    return BYTES_OF_A_STEP * script.get().size() + bytesOfPlans();
  }

  private long bytesOfPlans() {
    return records.stream()
        .mapToLong(
            plan ->
                BYTES_OF_A_STEP * (1 + plan.steps().size()) + BYTES_OF_A_BID * plan.bids().size())
        .sum();
  }

  void planning(int number, Optional<String> cause) {
    records.add(new PlanRecord(number, clock.now(), cause));
    keepWhatThereIsRoomFor();
  }

  void answered(List<BidRecord> bids, int notAsked) {
    changeLatest(plan -> plan.answered(bids, notAsked));
    keepWhatThereIsRoomFor();
  }

  private void keepWhatThereIsRoomFor() {
    while (records.size() > MOST || records.size() > 1 && bytesOfPlans() > MOST_BYTES) {
      records.remove(0);
    }
  }

  /** What is under way and wanted by this plan, too, goes on. */
  void adopted(Plan plan, boolean toSee, Sentences sentences) {
    Map<Integer, Double> starts = plan.starts();
    List<StepRecord> steps =
        plan.steps().stream()
            .map(
                step -> {
                  double start = Objects.requireNonNull(starts.get(step.number()));
                  StepRecord fresh = new StepRecord(step, sentences.step(step), seconds(start));
                  return underway(step.key())
                      .flatMap(StepRecord::begun)
                      .map(fresh::begunAt)
                      .orElse(fresh);
                })
            .toList();
    dropWhatWaits();
    changeLatest(
        record ->
            record.made(
                new PlanRecord.Made(
                    clock.now(), toSee, plan.cost(), seconds(plan.seconds()), steps)));
    keepWhatThereIsRoomFor();
  }

  private static Duration seconds(double seconds) {
    return Duration.ofMillis(Math.round(seconds * 1000));
  }

  private Optional<StepRecord> underway(StepKey key) {
    return records.stream()
        .flatMap(plan -> plan.steps().stream())
        .filter(step -> step.state() == State.UNDER_WAY && step.step().key().equals(key))
        .findFirst();
  }

  /** It is one of the plan that was adopted last. */
  void begun(Step step) {
    Predicate<StepRecord> same = same(step.key());
    for (int i = records.size() - 1; i >= 0; i--) {
      if (records.get(i).made().isPresent()) {
        records.set(i, records.get(i).with(one -> same.test(one) ? one.begunAt(clock.now()) : one));
        return;
      }
    }
  }

  void done(Step step) {
    ended(step, State.DONE, Optional.empty());
  }

  void notDone(Step step, String problem) {
    ended(step, State.FAILED, Optional.of(problem));
  }

  /** It waits still. */
  void notBegun(Step step) {
    Predicate<StepRecord> same = same(step.key());
    changeAll(one -> one.state() == State.UNDER_WAY && same.test(one) ? one.waitingAgain() : one);
  }

  void calledOff(Step step) {
    ended(step, State.CALLED_OFF, Optional.empty());
  }

  private void ended(Step step, State how, Optional<String> why) {
    Predicate<StepRecord> same = same(step.key());
    changeAll(
        one ->
            one.state() == State.UNDER_WAY && same.test(one)
                ? one.endedAt(clock.now(), how, why)
                : one);
  }

  private static Predicate<StepRecord> same(StepKey key) {
    return one -> one.step().key().equals(key);
  }

  /** The goal is over: what runs for it is called off, and nothing begins any more. */
  void over() {
    changeAll(
        one ->
            one.state() == State.UNDER_WAY
                ? one.endedAt(clock.now(), State.CALLED_OFF, Optional.empty())
                : one);
    dropWhatWaits();
  }

  private void dropWhatWaits() {
    changeAll(one -> one.state() == State.WAITING ? one.dropped() : one);
  }

  private void changeAll(UnaryOperator<StepRecord> now) {
    records.replaceAll(plan -> plan.with(now));
  }

  private void changeLatest(UnaryOperator<PlanRecord> now) {
    if (!records.isEmpty()) {
      int latest = records.size() - 1;
      records.set(latest, now.apply(records.get(latest)));
    }
  }
}
