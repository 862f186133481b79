package org.maestro.coordination.recovery;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Latest;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.undoing.FormerFacts;
import org.maestro.planning.api.StepKey;
import org.maestro.rats.bounded.BoundedMap;

/**
 * Gives each call its name, writes it down before it is sent and when it is over, and sends calls
 * of coordinators before this one again. The coordinator's thread only.
 */
public final class JournaledDispatcher implements ActionDispatcher {
  private static final long MOST_BYTES_OF_ENDED = 64 << 10;
  private static final long BYTES_OF_EACH = 128;

  private static final int MOST_OWED = 256;

  private final ActionDispatcher dispatcher;
  private final Journal journal;
  private final Roster roster;
  private final FormerFacts former;
  private final String life;
  private final Map<String, Integer> callsByGoal = new HashMap<>();
  private final Latest<Integer> callsOfEnded =
      new Latest<>(MOST_BYTES_OF_ENDED, calls -> BYTES_OF_EACH);

  /** Orders of which nobody knows what became of them. */
  private final Map<Owed, Request> owed = BoundedMap.ofNewest(MOST_OWED);

  private record Owed(String goalId, StepKey step) {}

  /**
   * @param former told of each order
   * @param since when this coordinator began, which makes the names of its calls its own
   */
  public JournaledDispatcher(
      ActionDispatcher dispatcher,
      Journal journal,
      Roster roster,
      FormerFacts former,
      Instant since) {
    this.dispatcher = dispatcher;
    this.journal = journal;
    this.roster = roster;
    this.former = former;
    this.life = Long.toString(since.toEpochMilli(), Character.MAX_RADIX);
  }

  /** An order that names its call already stands in the journal. */
  @Override
  public Handle perform(Request order, Consumer<Report> reported) {
    if (!order.ends()) {
      former.begun(order);
    }
    if (order.call().isPresent()) {
      Sending again = new Sending(order, reported);
      again.send();
      return again;
    }
    Request named = owed(order).orElseGet(() -> order.named(name(order)));
    journal.write(
        new JournalEntry.Begun(
            order.goalId(),
            named.call().orElseThrow(),
            order.step().key(),
            order.step().number(),
            order.step().seconds(),
            named.parameters(),
            named.timeout()));
    Sending sending = new Sending(named, reported);
    journal.afterwards(sending::send);
    return sending;
  }

  @Override
  public void ask(String member, Runnable heard) {
    dispatcher.ask(member, heard);
  }

  @Override
  public void callOff(String member, Call call) {
    dispatcher.callOff(member, call);
  }

  @Override
  public void alive(String goalId, String member, String feature) {
    dispatcher.alive(goalId, member, feature);
  }

  @Override
  public boolean isOwed(String goalId, StepKey step) {
    return Optional.ofNullable(owed.get(new Owed(goalId, step))).filter(this::isKnown).isPresent();
  }

  @Override
  public List<Request> giveUpOwed(String goalId, Predicate<StepKey> unwanted) {
    List<Request> givenUp =
        owed.entrySet().stream()
            .filter(entry -> entry.getKey().goalId().equals(goalId))
            .filter(entry -> unwanted.test(entry.getKey().step()))
            .map(Map.Entry::getValue)
            .toList();
    owed.values().removeAll(givenUp);
    return givenUp.stream().filter(this::isKnown).map(Request::ending).toList();
  }

  /** Whether its member still lives the life in which it was told. */
  private boolean isKnown(Request order) {
    Optional<String> life = order.call().flatMap(Call::life);
    return life.isPresent() && life.equals(roster.life(order.step().member()));
  }

  /**
   * The same order as before, in the same words, if its member still lives the life in which it was
   * told: that is no second time for it, but a question for what became of the first.
   */
  private Optional<Request> owed(Request order) {
    boolean known = isOwed(order.goalId(), order.step().key());
    return Optional.ofNullable(owed.remove(new Owed(order.goalId(), order.step().key())))
        .filter(former -> known)
        .map(
            former ->
                new Request(
                    order.goalId(),
                    order.step(),
                    former.parameters(),
                    former.timeout(),
                    former.call()));
  }

  /** The goal is over: what comes to rest now is the last that is ordered for it. */
  public void over(String goalId) {
    List<String> beside =
        callsByGoal.keySet().stream().filter(id -> GoalId.isWithin(id, goalId)).toList();
    beside.forEach(this::callOffOwed);
    callsByGoal.keySet().removeAll(beside);
    callOffOwed(goalId);
    callsOfEnded.put(goalId, Optional.ofNullable(callsByGoal.remove(goalId)).orElse(0));
  }

  private void callOffOwed(String goalId) {
    giveUpOwed(goalId, step -> true)
        .forEach(order -> dispatcher.callOff(order.step().member(), order.call().orElseThrow()));
  }

  private Call name(Request order) {
    int before = callsOfEnded.find(order.goalId()).orElse(0);
    int number = callsByGoal.merge(order.goalId(), before + 1, (calls, one) -> calls + 1);
    return new Call(order.goalId() + "-" + life + "-" + number, roster.life(order.step().member()));
  }

  /** One call on its way. */
  private final class Sending implements Handle {
    private final Request order;
    private final Consumer<Report> reported;
    private Optional<Handle> sent = Optional.empty();
    private boolean calledOff;

    private Sending(Request order, Consumer<Report> reported) {
      this.order = order;
      this.reported = reported;
    }

    private void send() {
      if (calledOff) {
        over(
            new Report(
                false, Map.of(), Optional.of("It was called off before it was sent."), List.of()));
      } else {
        sent = Optional.of(dispatcher.perform(order, this::over));
      }
    }

    @Override
    public Optional<Duration> aliveAt() {
      return sent.flatMap(Handle::aliveAt);
    }

    private void over(Report report) {
      if (order.ends()) {
        reported.accept(report);
        return;
      }
      if (report.unanswered() && !calledOff) {
        owed.put(new Owed(order.goalId(), order.step().key()), order);
      }
      journal.write(end(report));
      reported.accept(report);
      former.ended(order);
    }

    private JournalEntry end(Report report) {
      if (report.heldBy().isPresent()) {
        return new JournalEntry.NotBegun(order.goalId(), callId());
      }
      return report.succeeded() && order.step().feature().continuous()
          ? new JournalEntry.Established(order.goalId(), callId())
          : new JournalEntry.Ended(order.goalId(), callId(), report.problem());
    }

    @Override
    public void cancel() {
      calledOff = true;
      journal.write(new JournalEntry.CalledOff(order.goalId(), callId()));
      sent.ifPresent(Handle::cancel);
    }

    private String callId() {
      return order.call().orElseThrow().id();
    }
  }
}
