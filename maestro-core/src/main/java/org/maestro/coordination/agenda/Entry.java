package org.maestro.coordination.agenda;

import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * The life of a goal that is bound to a time or an event, as what watches for that sees it: time,
 * what is noted across restarts, and goals begun for it. The coordinator's thread only.
 */
final class Entry {
  /** Where the goal that was begun last is noted; before it is begun, so that it is begun once. */
  private static final String BEGUN = "1";

  private static final DateTimeFormatter MOMENT =
      DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm[:ss]", Locale.ROOT);
  private static final DateTimeFormatter TO_THE_MINUTE =
      DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm", Locale.ROOT);

  private final GoalLife life;
  private final Ports ports;
  private final ActiveGoals activeGoals;
  private final Beginnings goals;
  private final Map<String, JournalEntry.Noted> notes = new LinkedHashMap<>();
  private Clock.Timer timer = () -> {};
  private Optional<String> followed = Optional.empty();
  private Optional<Ending> ending = Optional.empty();
  private Optional<Duration> back = Optional.empty();
  private Optional<String> unborn = Optional.empty();
  private String missed = "";

  /** How it ends once nothing that it has begun is under way. */
  private record Ending(GoalState state, List<String> reasons) {}

  Entry(GoalLife life, Ports ports, ActiveGoals activeGoals, Beginnings goals) {
    this.life = life;
    this.ports = ports;
    this.activeGoals = activeGoals;
    this.goals = goals;
  }

  /** It was there before a restart. */
  void takeUp(List<JournalEntry.Noted> former) {
    former.forEach(note -> notes.put(note.path(), note));
    back = Optional.of(ports.clock().now());
    unborn = begunBefore().filter(id -> !goals.wasBegun(id));
  }

  /** Since when the platform is there again; empty when it was there all the time. */
  Optional<Duration> back() {
    return back;
  }

  ZoneId zone() {
    return ports.knowledge().home().timeZone().orElseGet(ZoneId::systemDefault);
  }

  Instant instant(Duration onClock) {
    return ports.clock().start().plus(onClock);
  }

  Duration onClock(Instant instant) {
    return Duration.between(ports.clock().start(), instant);
  }

  Duration now() {
    return ports.clock().now();
  }

  Duration statedAt() {
    return life.submittedAt();
  }

  Vocabulary vocabulary() {
    return ports.knowledge().home().vocabulary();
  }

  Snapshot known() {
    return ports.knowledge().snapshot();
  }

  /** Such as {@code 2026-11-27 22:30}. */
  String inWords(Duration onClock) {
    Instant moment = instant(onClock);
    boolean isWhole = moment.getEpochSecond() % 60 == 0;
    return (isWhole ? TO_THE_MINUTE : MOMENT).format(moment.atZone(zone()));
  }

  /** What was noted there. */
  Optional<JournalEntry.Noted> note(String path) {
    return Optional.ofNullable(notes.get(path));
  }

  void note(String path, Optional<Term> value, Optional<Duration> time) {
    JournalEntry.Noted note =
        new JournalEntry.Noted(life.id(), path, false, value, Optional.empty(), time);
    notes.put(path, note);
    ports.journal().write(note);
  }

  void note(String path, String text) {
    note(path, Optional.of(new Term.Text(text)), Optional.empty());
  }

  /** The texts that are noted at paths that begin so; empty where something else is. */
  Map<String, Optional<String>> texts(String pathsBegin) {
    Map<String, Optional<String>> texts = new LinkedHashMap<>();
    notes.forEach(
        (path, note) -> {
          if (path.startsWith(pathsBegin)) {
            texts.put(path, text(note));
          }
        });
    return texts;
  }

  private static Optional<String> text(JournalEntry.Noted note) {
    return note.value()
        .filter(Term.Text.class::isInstance)
        .map(value -> ((Term.Text) value).value());
  }

  /** Looked at then; this takes the place of what was to be looked at before. */
  void at(Duration due, Runnable then) {
    timer.cancel();
    Runnable unlessEnding =
        () -> {
          if (!isEnding()) {
            then.run();
          }
        };
    timer =
        ports
            .clock()
            .schedule(
                due.minus(now()),
                life.id(),
                () -> ports.owner().execute(() -> activeGoals.run(unlessEnding)));
  }

  boolean isEnding() {
    return life.isOver() || ending.isPresent();
  }

  /**
   * @param what it waits for, after "for"
   */
  void awaits(String what) {
    life.become(GoalPhase.AWAITING_OCCASION, "for " + what + missed);
  }

  /** Something that was to happen did not, since there was no platform. */
  void missed(String what) {
    missed = "; missed: " + what;
    tell(
        life.id(),
        StoryEntry.Kind.RESTART,
        "Missed while no platform ran, and not done: " + what + ".");
  }

  /** The last goal that was to be begun, if the platform ended before it was. */
  Optional<String> unborn() {
    return unborn;
  }

  /** The last goal that was to be begun before the restart. */
  Optional<String> begunBefore() {
    return note(BEGUN).flatMap(Entry::text);
  }

  /**
   * Begins a goal of its own.
   *
   * @param because as the end of a sentence
   * @param refused told why it cannot be
   * @return its id
   */
  String begin(Formula goal, String because, Consumer<String> refused) {
    missed = "";
    String id = goals.nextId();
    note(BEGUN, id);
    GoalRequest own = life.request();
    tell(
        life.id(),
        StoryEntry.Kind.STEP,
        "Begins %s, %s: %s.".formatted(id, because, SlPrinter.print(goal)));
    goals.begin(
        id,
        new GoalRequest(goal, own.requester(), own.priority(), own.deadline(), own.stakes()),
        () -> tell(id, StoryEntry.Kind.GOAL, "Begun by %s, %s.".formatted(life.id(), because)),
        why -> {
          followed = followed.filter(other -> !other.equals(id));
          tell(life.id(), StoryEntry.Kind.FAILED, id + " was not begun: " + why);
          refused.accept(why);
        });
    return id;
  }

  /**
   * Ends as that goal ends.
   *
   * @param detail after its id
   */
  void follow(String goalId, String detail) {
    if (!isEnding()) {
      listen(goalId, detail);
    }
  }

  /** The same, of a goal that was begun before a restart. */
  void followAgain(String goalId, String detail) {
    if (!listen(goalId, detail)) {
      followed = Optional.empty();
      end(GoalState.FAILED, "Nothing is known of " + goalId + " any more.", id());
    }
  }

  private boolean listen(String goalId, String detail) {
    followed = Optional.of(goalId);
    life.become(GoalPhase.FOLLOWING, goalId + detail);
    return goals.follow(goalId, outcome -> activeGoals.run(() -> over(outcome)));
  }

  /** The goal as which it ends; empty when it follows none. */
  Optional<String> followed() {
    return followed;
  }

  String id() {
    return life.id();
  }

  private void over(GoalOutcome outcome) {
    if (life.isOver()) {
      return;
    }
    followed = Optional.empty();
    life.add(outcome);
    if (ending.isPresent()) {
      end(ending.get().state(), false, Map.of(), ending.get().reasons());
    } else {
      List<String> reasons = new ArrayList<>();
      outcome.reasons().forEach(reason -> reasons.add(outcome.id() + ": " + reason));
      end(outcome.state(), outcome.confirmed(), outcome.binding(), reasons);
    }
  }

  boolean isHolding(String goalId) {
    return goals.isHolding(goalId);
  }

  /** Ends; what it follows is cancelled before. */
  void end(GoalState how, String reason, String who) {
    if (isEnding()) {
      return;
    }
    if (followed.isPresent()) {
      ending = Optional.of(new Ending(how, List.of(reason)));
      goals.cancel(followed.get(), who);
    } else {
      end(how, false, Map.of(), List.of(reason));
    }
  }

  private void end(
      GoalState how, boolean confirmed, Map<String, Term> binding, List<String> reasons) {
    timer.cancel();
    life.become(GoalPhase.ENDING);
    life.end(how, confirmed, binding, reasons);
    activeGoals.leave(life.id());
  }

  void tell(StoryEntry.Kind kind, String text) {
    tell(life.id(), kind, text);
  }

  private void tell(String goalId, StoryEntry.Kind kind, String text) {
    ports.story().tell(new StoryEntry(goalId, now(), kind, text));
  }
}
