package org.maestro.members;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.knowledge.api.Moment;
import org.maestro.knowledge.api.StepAccount;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.rats.protocol.MemberState;
import org.maestro.sl.Effect;
import org.maestro.sl.EffectTarget;

/**
 * A generic agent's picture of the member it stands for: what it described, and what runs on it.
 * Agent thread only.
 */
public final class MemberView {
  private static final int MOST_REMEMBERED = 64;

  private final String listener;
  private final Runnable askAgain;

  /** Of the calls that did what they were for, the latest, when the result of each was heard. */
  private final Map<String, Moment> ended = latest();

  /** When calls were begun; one may be asked for again that had no answer. */
  private final Map<String, Moment> firstBegun = latest();

  private final Map<String, FeatureType> features = new TreeMap<>();

  /** When each call that is under way was begun. */
  private final Map<String, Moment> underway = new TreeMap<>();

  /** What waits for the member to tell that a call is over, by call. */
  private final Map<String, Runnable> awaitsTelling = new TreeMap<>();

  private Optional<Device> device = Optional.empty();
  private boolean ready;
  private int running;
  private long heard;
  private boolean inDoubt;
  private Optional<Heard> last = Optional.empty();
  private Optional<MemberWord> heldBack = Optional.empty();
  private List<String> toldMeanwhile = List.of();

  /**
   * The last word of the member about itself.
   *
   * @param ended the latest calls that were over then; empty: the member does not tell
   */
  private record Heard(MemberWord word, Set<String> ended) {

    boolean isOver(String call) {
      return ended.contains(call);
    }

    boolean isAfter(Moment moment) {
      return word.moment().isAfter(moment);
    }

    /** Whether nobody can tell from it which calls were over. */
    boolean isSilent() {
      return ended.isEmpty();
    }
  }

  /**
   * @param listener no other that listens to the member, before or after, has the same name
   * @param askAgain has the member say once more what it says of itself: it has said so around a
   *     call, and nobody can tell whether before or after what the call did
   */
  public MemberView(String listener, Runnable askAgain) {
    this.listener = listener;
    this.askAgain = askAgain;
  }

  public Optional<Device> device() {
    return device;
  }

  /** A fact that the member tells in its maker's words, in those that all use. */
  String understood(String fact) {
    return device.map(known -> known.extension().synonyms().translated(fact)).orElse(fact);
  }

  public void describedAs(Device described) {
    device = Optional.of(described);
  }

  public boolean isReady() {
    return ready && device.isPresent();
  }

  /**
   * @param now false when it is lost: what it said of itself before, and what waits for a report
   *     that will not come any more, is no news then
   */
  public void ready(boolean now) {
    ready = now;
    if (!now) {
      heldBack = Optional.empty();
      last = Optional.empty();
      inDoubt = false;
    }
  }

  public Optional<FeatureType> feature(String name) {
    return device.stream()
        .flatMap(d -> d.features().stream())
        .filter(f -> f.name().equals(name))
        .findFirst();
  }

  /** A call is begun: what is heard from now on is said after it. */
  public void begun(String conversation, FeatureType feature) {
    running++;
    features.put(conversation, feature);
    underway.put(conversation, next());
  }

  /**
   * The call is over, or established.
   *
   * @param callId as the member knows the call
   * @return what the member has said of itself around it
   */
  public Optional<StepAccount> account(
      String conversation, String callId, FeatureType feature, boolean succeeded) {
    Moment now = next();
    Optional<Moment> call = Optional.ofNullable(underway.get(conversation));
    boolean includesStep = last.filter(heard -> heard.isOver(callId)).isPresent();
    if (succeeded && !feature.continuous()) {
      ended.put(callId, now);
      boolean changesIt = feature.learns().isEmpty();
      boolean spokeSince =
          call.filter(begun -> last.filter(h -> h.isAfter(begun)).isPresent()).isPresent();
      if (changesIt && spokeSince && last.get().isSilent()) {
        inDoubt = false;
        askAgain.run();
      } else {
        inDoubt = changesIt && !includesStep;
      }
    }
    return call.map(
        known -> {
          Moment begun = firstBegun.computeIfAbsent(callId, id -> known);
          return new StepAccount(begun, now, last.map(Heard::word), includesStep);
        });
  }

  /**
   * Whether the member may be about to tell that the call is over: it tells so of others, or was
   * never called before, and it has spoken.
   */
  boolean mayStillTellOf(String call, FeatureType feature) {
    return !feature.continuous()
        && feature.learns().map(this::speaksOf).orElse(true)
        && last.filter(heard -> !heard.isOver(call))
            .filter(heard -> !heard.isSilent() || ended.isEmpty())
            .isPresent();
  }

  private boolean speaksOf(Effect learnt) {
    Set<String> names =
        EffectTarget.of(learnt).stream().map(EffectTarget::name).collect(Collectors.toSet());
    return last.filter(heard -> !AwaitedFacts.among(heard.word().facts(), names).isEmpty())
        .isPresent();
  }

  /** The action is run once, when the member tells that the call is over. */
  void whenItTellsOf(String call, Runnable action) {
    awaitsTelling.put(call, action);
  }

  void forgetCall(String call) {
    awaitsTelling.remove(call);
  }

  /** The call is over, or established; returns what the member said of itself meanwhile. */
  public Optional<MemberWord> over() {
    running--;
    Optional<MemberWord> word = heldBack;
    if (running == 0) {
      heldBack = Optional.empty();
      return word;
    }
    return Optional.empty();
  }

  public void forget(String conversation) {
    underway.remove(conversation);
    features.remove(conversation);
  }

  /**
   * While a call runs, what the member says of itself waits for the call's report, so that
   * knowledge never shows half a step; but for what is awaited and no call under way changes.
   *
   * @return what may be told now
   */
  public Optional<MemberWord> said(MemberState state) {
    Set<String> over = over(state);
    Optional<MemberWord> told = heard(new MemberWord(state.values(), momentOf(state)), over);
    over.stream().map(awaitsTelling::remove).filter(Objects::nonNull).forEach(Runnable::run);
    return told;
  }

  /** The member has withdrawn what it said of itself. */
  public Optional<MemberWord> saidNothing() {
    return heard(new MemberWord(List.of(), next()), Set.of());
  }

  private Optional<MemberWord> heard(MemberWord word, Set<String> over) {
    Heard now = new Heard(word, over);
    last = Optional.of(now);
    if (inDoubt) {
      inDoubt = false;
      if (now.isSilent()) {
        askAgain.run();
      }
    }
    if (running == 0) {
      toldMeanwhile = List.of();
      return Optional.of(word);
    }
    heldBack = Optional.of(word);
    return device.flatMap(known -> awaited(known, word));
  }

  private Optional<MemberWord> awaited(Device known, MemberWord word) {
    Set<String> names = AwaitedFacts.names(known, features.values());
    List<String> facts =
        AwaitedFacts.among(word.facts().stream().map(this::understood).toList(), names);
    if (names.isEmpty() || facts.equals(toldMeanwhile)) {
      return Optional.empty();
    }
    toldMeanwhile = facts;
    return Optional.of(new MemberWord(facts, word.moment(), names));
  }

  /**
   * A broker keeps the order of one topic, and not always that of two: a state that was sent before
   * a result may come after it. It was if it says that the call goes on, or does not name it though
   * it names one whose result came before; what is not named any more is older than all that is.
   */
  private Moment momentOf(MemberState state) {
    Set<String> over = over(state);
    LongStream goesOn = numbers(Stream.concat(state.running().stream(), state.queue().stream()));
    OptionalLong named = numbers(over.stream()).min();
    LongStream unnamed =
        named.isEmpty()
            ? LongStream.empty()
            : numbers(ended.keySet().stream().filter(call -> !over.contains(call)))
                .filter(number -> number > named.getAsLong());
    return LongStream.concat(goesOn, unnamed).min().stream()
        .mapToObj(number -> new Moment(listener, number - 1))
        .findFirst()
        .orElseGet(this::next);
  }

  private LongStream numbers(Stream<String> calls) {
    return calls.map(ended::get).filter(Objects::nonNull).mapToLong(Moment::number);
  }

  private static Set<String> over(MemberState state) {
    return state.recent().stream()
        .map(MemberState.Ended::id)
        .collect(Collectors.toUnmodifiableSet());
  }

  private static Map<String, Moment> latest() {
    return BoundedMap.ofNewest(MOST_REMEMBERED);
  }

  /** One number is left free before each. */
  private Moment next() {
    heard += 2;
    return new Moment(listener, heard);
  }
}
