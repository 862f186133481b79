package org.maestro.rats.member;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.CostExchange;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Decides what becomes of each call heard on the bus: for others, refused, answered at once, or
 * queued (Three-layered architecture, 3.2.3; M61). Clock thread only.
 */
final class Reception {

  private static final Logger LOG = LoggerFactory.getLogger(Reception.class);

  /** Brokers count what is left of an expiry in whole seconds, some downwards. */
  private static final Duration EXPIRY_GRAIN = Duration.ofSeconds(1);

  private final MemberProfile profile;
  private final String boot;
  private final Topics topics;
  private final CallPolicy policy;
  private final MemberCondition condition;
  private final CallAnswers answers;
  private final TaskQueue tasks;
  private final Impatience impatience;
  private final Predicate<String> anotherLife;
  private final RightsWatch rights;
  private final CallerClocks callers;
  private final Runnable describe;
  private final Clock clock;
  private final WireFormat wire = new WireFormat();
  private final Complaints complaints;

  /**
   * @param anotherLife whether a boot may be that of another who is there and answers for itself
   */
  Reception(
      MemberProfile profile,
      String boot,
      Topics topics,
      CallPolicy policy,
      MemberCondition condition,
      CallAnswers answers,
      TaskQueue tasks,
      Impatience impatience,
      Predicate<String> anotherLife,
      Runnable describe,
      Complaints complaints,
      Clock clock) {
    this.profile = profile;
    this.boot = boot;
    this.topics = topics;
    this.policy = policy;
    this.condition = condition;
    this.answers = answers;
    this.tasks = tasks;
    this.impatience = impatience;
    this.anotherLife = anotherLife;
    this.describe = describe;
    this.complaints = complaints;
    this.clock = clock;
    this.callers = new CallerClocks(clock);
    this.rights = new RightsWatch(profile.id(), policy, tasks, clock);
  }

  void heard(Message message, Duration arrivedAt) {
    if (message.retained()) {
      complain(message, "was sent with the retain flag, and is not executed");
      return;
    }
    Call call;
    try {
      call = wire.decodeCall(message.payload());
    } catch (MalformedMessageException malformed) {
      if (!wire.isForAnother(message.payload(), profile.id())) {
        refuseMalformed(message, malformed);
      }
      return;
    }
    Optional<String> caller = topics.callerOf(message.topic());
    if (caller.isPresent() && !caller.get().equals(call.from())) {
      complain(message, "came in the name of " + call.from() + ", and is ignored");
    } else if (caller.isEmpty() && policy.isSecured()) {
      complain(message, "came on the bare topic of a secured site, and is ignored");
    } else if (isForMe(call)) {
      take(call, message.remainingExpiry(), arrivedAt, callers.age(call, arrivedAt));
    } else {
      impatience.overheard(call, arrivedAt);
    }
  }

  private void complain(Message message, String what) {
    String sender = topics.callerOf(message.topic()).orElse(message.topic());
    if (complaints.isDue(sender)) {
      LOG.warn("{} heard of {}: the call {}", profile.id(), sender, what);
    }
  }

  private void refuseMalformed(Message message, MalformedMessageException malformed) {
    String what = Objects.requireNonNullElse(malformed.getMessage(), malformed.toString());
    complain(message, "is malformed: " + what);
    Optional<String> caller = topics.callerOf(message.topic());
    wire.addressOf(message.payload())
        .filter(address -> address.member().equals(profile.id()) && caller.isPresent())
        .ifPresent(
            address ->
                answers.rejectedUnremembered(address.id(), caller.get(), malformed.code(), what));
  }

  /** Everybody may end what it called itself. */
  private boolean isAllowed(Call call) {
    boolean cancel =
        ReservedFeature.of(call.feature()).filter(ReservedFeature.CANCEL::equals).isPresent();
    return cancel || mayCall(call);
  }

  private boolean mayCall(Call call) {
    return policy.allows(call.from(), profile.id(), call.feature());
  }

  private boolean isForMe(Call call) {
    return call.member()
        .map(profile.id()::equals)
        .orElseGet(
            () ->
                profile.features().containsKey(call.feature())
                    || ReservedFeature.of(call.feature()).isPresent());
  }

  /**
   * @param age how long it was on its way; empty when nobody knows
   */
  private void take(
      Call call, Optional<Duration> remainingExpiry, Duration arrivedAt, Optional<Duration> age) {
    if (call.boot().filter(anotherLife).isPresent()) {
      return;
    }
    if (call.boot().isPresent() && !call.boot().get().equals(boot)) {
      String message = "The call was meant for the boot " + call.boot().get() + " before this one";
      answers.rejectedUnremembered(call.id(), call.from(), ErrorCode.RESTARTED, message);
      return;
    }
    if (!isAllowed(call)) {
      String message =
          "The rules of the site do not let %s call %s of %s"
              .formatted(call.from(), call.feature(), profile.id());
      answers.rejectedUnremembered(call.id(), call.from(), ErrorCode.NOT_AUTHORISED, message);
      return;
    }
    switch (answers.register(call)) {
      case ANSWERED -> LOG.debug("{} has answered the call {} before", profile.id(), call.id());
      case UNDERWAY -> tasks.tellAgain(call);
      case OTHER_BODY ->
          answers.rejectedUnremembered(
              call.id(),
              call.from(),
              ErrorCode.DUPLICATE_ID,
              "Another call of the id " + call.id() + " came before; each call needs its own");
      case NEW -> {
        Duration limit = limit(call, remainingExpiry).minus(clock.now().minus(arrivedAt));
        if (limit.isNegative() || limit.isZero()) {
          answers.rejected(call, ErrorCode.EXPIRED, "The call arrived after its time had passed");
        } else {
          ReservedFeature.of(call.feature())
              .ifPresentOrElse(
                  reserved -> performReserved(reserved, call),
                  () -> performInTime(call, limit, age.orElse(Duration.ZERO)));
        }
      }
    }
  }

  /** What leads to a safe state, or only asks, is never too late; what moves something is. */
  private void performInTime(Call call, Duration limit, Duration age) {
    Duration left = call.timeout().minus(age);
    if (left.isNegative() || left.isZero()) {
      answers.rejected(
          call,
          ErrorCode.EXPIRED,
          "The call was on its way for %d ms at least, and was to be over after %d ms"
              .formatted(age.toMillis(), call.timeout().toMillis()));
    } else {
      perform(call, left.compareTo(limit) < 0 ? left : limit);
    }
  }

  private Duration limit(Call call, Optional<Duration> remainingExpiry) {
    return remainingExpiry
        .map(left -> left.plus(EXPIRY_GRAIN))
        .map(clock::ofWall)
        .filter(left -> left.compareTo(call.timeout()) < 0)
        .orElse(call.timeout());
  }

  private void perform(Call call, Duration limit) {
    MemberProfile.Feature feature = profile.features().get(call.feature());
    if (feature == null) {
      answers.rejected(
          call, ErrorCode.UNKNOWN_FEATURE, profile.id() + " has no feature " + call.feature());
      return;
    }
    List<String> missing =
        feature.required().stream()
            .filter(name -> !call.parameters().containsKey(name))
            .sorted()
            .toList();
    Optional<String> disabled = condition.whyDisabled(feature.id());
    if (!missing.isEmpty()) {
      answers.rejected(
          call,
          ErrorCode.INVALID_PARAMETERS,
          feature.id() + " needs the parameters " + String.join(", ", missing));
    } else if (disabled.isPresent()) {
      answers.rejected(call, ErrorCode.DISABLED, disabled.get());
    } else if (tasks.becomesSafe()) {
      answers.rejected(
          call, ErrorCode.DISABLED, profile.id() + " was told to be safe; try when it is");
    } else if (tasks.full()) {
      answers.rejected(
          call, ErrorCode.QUEUE_FULL, "The queue of " + profile.id() + " is full; try later");
    } else {
      tasks.add(call, feature, limit);
      rights.begin();
    }
  }

  private void performReserved(ReservedFeature reserved, Call call) {
    switch (reserved) {
      case PING -> answers.succeeded(call, Map.of());
      case DESCRIBE -> {
        describe.run();
        answers.succeeded(call, Map.of());
      }
      case SAFE -> tasks.makeSafe(() -> answers.succeeded(call, Map.of()));
      case COST -> answerCost(call);
      case CANCEL -> cancel(call);
    }
  }

  private void cancel(Call call) {
    if (call.parameters().get("id") instanceof String id) {
      answers.succeeded(call, Map.of("found", tasks.cancel(call.from(), id, mayCall(call))));
    } else {
      answers.rejected(
          call, ErrorCode.INVALID_PARAMETERS, "$cancel needs the parameter id, a call's id");
    }
  }

  private void answerCost(Call call) {
    Optional<CostExchange> exchange = CostExchange.of(call.parameters());
    Optional<MemberProfile.Feature> feature =
        exchange.map(asked -> profile.features().get(asked.feature()));
    if (exchange.isEmpty()) {
      answers.rejected(
          call,
          ErrorCode.INVALID_PARAMETERS,
          "$cost needs the parameters feature, a text, and sets, a list of parameter sets");
    } else if (feature.isEmpty()) {
      String message = profile.id() + " has no feature " + exchange.get().feature();
      answers.rejected(call, ErrorCode.UNKNOWN_FEATURE, message);
    } else {
      new CostInquiry(
              profile.id(),
              feature.get(),
              exchange.get().sets(),
              (set, answer) -> impatience.told(call.from(), feature.get(), set, answer))
          .begin(
              clock,
              costs -> answers.succeeded(call, CostExchange.values(costs)),
              reason -> answers.timedOut(call, reason));
    }
  }
}
