package org.maestro.rats.member;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.time.Clock;

/**
 * The member's impatience with what others are at (ALLIANCE, M43). It remembers calls to others of
 * features that it has too, and offers their holder to take one over, once, in two cases: it has
 * become cheaper than what the holder still counts on, which it was not when the call was made; or
 * the other is late by longer than the member would need for all of it. It never begins anything by
 * itself: the holder decides. Clock thread only.
 */
final class Impatience {

  private static final int MOST_WATCHED = 64;

  /** So much less it must cost than what is left of the other's; a change of hands costs, too. */
  private static final double LEAST_SAVING = 0.1;

  private final MemberProfile profile;
  private final CallPolicy policy;
  private final MemberVoice voice;
  private final MemberCondition condition;
  private final TaskQueue tasks;
  private final Clock clock;
  private final Map<Key, Watched> watched = new LinkedHashMap<>();

  Impatience(
      MemberProfile profile,
      CallPolicy policy,
      MemberVoice voice,
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
    Watched one = new Watched(call, since, price(call).flatMap(CostAnswer::cost));
    watched.put(key, one);
    one.end = clock.schedule(call.timeout(), profile.id(), () -> forget(key));
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
        waitUntilLate(one);
      } else if (!runs && !other.queue().contains(id) && one.seenRunning) {
        forget(entry.getKey());
      }
    }
  }

  /** Nothing else may happen that makes this member look at it again. */
  private void waitUntilLate(Watched one) {
    double own = price(one.call).flatMap(CostAnswer::seconds).orElse(one.expected().seconds());
    double left = one.expected().seconds() + own - passed(one);
    one.late =
        Optional.of(
            clock.schedule(
                Duration.ofMillis((long) Math.ceil(Math.max(0, left) * 1_000)),
                profile.id(),
                this::reconsider));
  }

  /** Something about this member has changed, and perhaps its prices, or time has passed. */
  void reconsider() {
    watched.values().stream().filter(one -> !one.offered).forEach(this::reconsider);
  }

  private void reconsider(Watched one) {
    Optional<CostAnswer> price = price(one.call);
    Optional<Double> cost = price.flatMap(CostAnswer::cost);
    if (cost.isPresent()) {
      double seconds = price.get().seconds().orElse(cost.get());
      if (hasBecomeCheaper(one, cost.get()) || isLateBy(one, seconds)) {
        one.offered = true;
        voice.offer(one.call, new Offer(one.call.id(), one.call.feature(), cost.get(), seconds));
      }
    }
  }

  private boolean hasBecomeCheaper(Watched one, double cost) {
    double share = 1 - passed(one) / Math.max(one.expected().seconds(), Double.MIN_VALUE);
    double left = one.expected().cost() * Math.max(0, share);
    return one.priceThen.filter(then -> cost >= then).isEmpty() && cost < left * (1 - LEAST_SAVING);
  }

  private boolean isLateBy(Watched one, double seconds) {
    return one.seenRunning && passed(one) >= one.expected().seconds() + seconds;
  }

  private double passed(Watched one) {
    return clock.now().minus(one.since).toNanos() / 1e9;
  }

  /** Empty when it could not begin now. */
  private Optional<CostAnswer> price(Call call) {
    MemberProfile.Feature feature = profile.features().get(call.feature());
    boolean able =
        call.parameters().keySet().containsAll(feature.required())
            && condition.whyDisabled(feature.id()).isEmpty()
            && tasks.couldBegin(feature);
    return able
        ? Optional.of(Reception.cost(profile.id(), feature, call.parameters()))
        : Optional.empty();
  }

  private record Key(String from, String id) {}

  private static final class Watched {
    private final Call call;
    private final Duration since;
    private final Optional<Double> priceThen;
    private Clock.Timer end = () -> {};
    private Optional<Clock.Timer> late = Optional.empty();
    private boolean seenRunning;
    private boolean offered;

    private Watched(Call call, Duration since, Optional<Double> priceThen) {
      this.call = call;
      this.since = since;
      this.priceThen = priceThen;
    }

    private Call.Expectation expected() {
      return call.expects().orElseThrow();
    }
  }
}
