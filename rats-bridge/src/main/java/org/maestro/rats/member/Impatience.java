package org.maestro.rats.member;

import java.time.Duration;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.time.Clock;

/**
 * The member's impatience with what others are at (ALLIANCE, Three-layered architecture, 3.2.1;
 * M43). It remembers calls to others of features that it has too, and offers their holder to take
 * one over, once, in two cases: something about this member has changed since the call, or since it
 * told the holder its price for that, and it is cheaper than what the holder still counts on and
 * than what it told; or the other is late, as far as can be seen, by longer than the member would
 * need for all of it. It never begins anything by itself: the holder decides. Clock thread only.
 *
 * <p>Many members overhear each call, and a price can be a search for a way: nothing is priced
 * before it could lead to an offer.
 */
final class Impatience {

  private static final int MOST_WATCHED = 64;

  /** So much less it must cost than what is left of the other's; a change of hands costs, too. */
  private static final double LEAST_SAVING = 0.1;

  /** Nobody looks at what takes a little longer than expected; a factor. */
  private static final double USUAL_DELAY = 1.1;

  private final MemberProfile profile;
  private final CallPolicy policy;
  private final MemberPublisher voice;
  private final MemberCondition condition;
  private final TaskQueue tasks;
  private final Clock clock;
  private final Map<Key, Watched> watched = new LinkedHashMap<>();
  private final Map<Question, Told> told = new LinkedHashMap<>();
  private long changes;

  Impatience(
      MemberProfile profile,
      CallPolicy policy,
      MemberPublisher voice,
      MemberCondition condition,
      TaskQueue tasks,
      Clock clock) {
    this.profile = profile;
    this.policy = policy;
    this.voice = voice;
    this.condition = condition;
    this.tasks = tasks;
    this.clock = clock;
  }

  /** Whether it cares for any call that is not its own. */
  static boolean isOf(MemberProfile profile) {
    return !profile.takesOver().isEmpty();
  }

  /** A call to somebody else. */
  void overheard(Call call, Duration arrivedAt) {
    if (ReservedFeature.of(call.feature()).filter(ReservedFeature.CANCEL::equals).isPresent()) {
      forget(new Key(call.from(), String.valueOf(call.parameters().get("id"))));
    } else if (concerns(call)) {
      Key key = new Key(call.from(), call.id());
      if (!watched.containsKey(key)) {
        watch(key, call, arrivedAt);
      }
    }
  }

  private boolean concerns(Call call) {
    return call.member().isPresent()
        && call.expects().isPresent()
        && profile.takesOver().contains(call.feature())
        && policy.allows(call.from(), profile.id(), call.feature());
  }

  private void watch(Key key, Call call, Duration since) {
    if (watched.size() >= MOST_WATCHED) {
      forget(watched.keySet().iterator().next());
    }
    Question question = question(call.from(), takenOver(call), call.parameters());
    Optional<Told> before = Optional.ofNullable(told.get(question));
    Watched one = new Watched(call, since, before.map(Told::cost));
    watched.put(key, one);
    one.end = clock.schedule(call.timeout(), profile.id(), () -> forget(key));
    if (policy.isSecured()) {
      wakeWhenOverdue(one);
    }
    before
        .filter(price -> price.lookedAt() < changes)
        .ifPresent(
            price -> {
              told.put(question, new Told(price.cost(), changes));
              reconsider(one, true);
            });
  }

  /** The member has said what that would cost. */
  void told(
      String caller, MemberProfile.Feature feature, Map<String, Object> set, CostAnswer answer) {
    if (profile.takesOver().contains(feature.id()) && answer.cost().isPresent()) {
      Question question = question(caller, feature, set);
      told.remove(question);
      if (told.size() >= MOST_WATCHED) {
        told.remove(told.keySet().iterator().next());
      }
      told.put(question, new Told(answer.cost().get(), changes));
    }
  }

  /** A call may say more than what it was asked for, such as where its plan goes on. */
  private static Question question(
      String caller, MemberProfile.Feature feature, Map<String, Object> parameters) {
    Map<String, Object> required = new HashMap<>(parameters);
    required.keySet().retainAll(feature.required());
    return new Question(caller, feature.id(), required);
  }

  private void forget(Key key) {
    Watched gone = watched.remove(key);
    if (gone != null) {
      gone.end.cancel();
      gone.late.ifPresent(Clock.Timer::cancel);
    }
  }

  /** Another member tells what it is at: that says when it is done. */
  void heard(MemberState other) {
    for (Map.Entry<Key, Watched> entry : List.copyOf(watched.entrySet())) {
      Watched one = entry.getValue();
      if (one.call.member().filter(other.member()::equals).isEmpty()) {
        continue;
      }
      String id = one.call.id();
      boolean runs = other.running().contains(id);
      if (runs && !one.seenRunning) {
        one.seenRunning = true;
        wakeWhenOverdue(one);
      } else if (!runs && !other.queue().contains(id) && one.seenRunning) {
        forget(entry.getKey());
      }
    }
  }

  private void wakeWhenOverdue(Watched one) {
    wakeAfter(one, one.expected().seconds() * USUAL_DELAY - passed(one));
  }

  /** Nothing else may happen that makes this member look at it again. */
  private void wakeAfter(Watched one, double seconds) {
    one.late.ifPresent(Clock.Timer::cancel);
    one.late =
        Optional.of(
            clock.schedule(
                Duration.ofMillis((long) Math.ceil(Math.max(0, seconds) * 1_000)),
                profile.id(),
                () -> reconsider(one, false)));
  }

  /** Something about this member has changed, and perhaps its prices. */
  void changed() {
    changes++;
    watched.values().forEach(one -> reconsider(one, true));
  }

  private void reconsider(Watched one, boolean changed) {
    if (one.offered || !changed && !isOverdue(one)) {
      return;
    }
    Optional<CostAnswer> price = price(one.call);
    Optional<Double> cost = price.flatMap(CostAnswer::cost);
    if (cost.isEmpty()) {
      return;
    }
    double seconds = price.get().seconds().orElse(cost.get());
    double left = one.expected().seconds() + seconds - passed(one);
    if (changed && isCheaper(one, cost.get()) || isOverdue(one) && left <= 0) {
      one.offered = true;
      voice.offer(one.call, new Offer(one.call.id(), one.call.feature(), cost.get(), seconds));
    } else if (isOverdue(one)) {
      wakeAfter(one, left);
    }
  }

  private boolean isCheaper(Watched one, double cost) {
    double share = 1 - passed(one) / Math.max(one.expected().seconds(), Double.MIN_VALUE);
    double left = one.expected().cost() * Math.max(0, share);
    return one.toldBefore.filter(then -> cost >= then).isEmpty()
        && cost < left * (1 - LEAST_SAVING);
  }

  /**
   * On a secured site nobody sees whether another is at it still: there the holder, who knows,
   * passes over an offer for what has ended.
   */
  private boolean isOverdue(Watched one) {
    boolean mayBeAtIt = one.seenRunning || policy.isSecured();
    return mayBeAtIt && passed(one) >= one.expected().seconds();
  }

  private double passed(Watched one) {
    return clock.now().minus(one.since).toNanos() / 1e9;
  }

  /** Empty when it could not begin now, or not do it; why not helps nobody here. */
  private Optional<CostAnswer> price(Call call) {
    MemberProfile.Feature feature = takenOver(call);
    boolean able =
        call.parameters().keySet().containsAll(feature.required())
            && !condition.isDisabled(feature.id())
            && tasks.couldBegin(feature);
    return able ? cost(feature, call.parameters()) : Optional.empty();
  }

  /** The own feature by which it would do what the call asks for. */
  private MemberProfile.Feature takenOver(Call call) {
    return Objects.requireNonNull(profile.features().get(call.feature()));
  }

  private Optional<CostAnswer> cost(MemberProfile.Feature feature, Map<String, Object> parameters) {
    try {
      return feature.procedure().costIfAble(parameters);
    } catch (RuntimeException fault) {
      CostInquiry.logBroken(profile.id(), feature, fault);
      return Optional.empty();
    }
  }

  private record Key(String from, String id) {}

  private record Question(String caller, String feature, Map<String, Object> required) {}

  /**
   * A price that a caller counts on.
   *
   * @param lookedAt how often the member had changed when it was last looked at
   */
  private record Told(double cost, long lookedAt) {}

  private static final class Watched {
    private final Call call;
    private final Duration since;
    private final Optional<Double> toldBefore;
    private Clock.Timer end = () -> {};
    private Optional<Clock.Timer> late = Optional.empty();
    private boolean seenRunning;
    private boolean offered;

    private Watched(Call call, Duration since, Optional<Double> toldBefore) {
      this.call = call;
      this.since = since;
      this.toldBefore = toldBefore;
    }

    private Call.Expectation expected() {
      return call.expects().orElseThrow();
    }
  }
}
