package org.maestro.rats.link;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.Release;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.PublishException;
import org.maestro.rats.transport.Transport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The calls of a controller that have no outcome yet; each gets exactly one. Clock thread only. */
final class OpenCalls {

  private static final Logger LOG = LoggerFactory.getLogger(OpenCalls.class);

  /** Simulated time beyond t for the member's exit strategy and its answer, unless stated. */
  private static final Duration GRACE = Duration.ofSeconds(5);

  /** The same on the wall, for a real bus. */
  private static final Duration WALL_GRACE = Duration.ofSeconds(2);

  /** A member bounds its exit strategies to one minute. */
  private static final Duration CANCEL_LIMIT = Duration.ofSeconds(60);

  private static final String UNKNOWN_STATE = "unknown";

  private final String controller;
  private final Topics topics;
  private final Transport transport;
  private final Clock clock;
  private final Complaints complaints;
  private final WireFormat wire = new WireFormat();
  private final Map<String, Open> open = new LinkedHashMap<>();

  private final CallStamps stamps;

  private final LateResults late = new LateResults();

  OpenCalls(
      String controller, Topics topics, Transport transport, Clock clock, Complaints complaints) {
    this.complaints = complaints;
    this.controller = controller;
    this.stamps = new CallStamps(clock);
    this.topics = topics;
    this.transport = transport;
    this.clock = clock;
  }

  /**
   * @param call names the life of the member that is meant, or means the present one
   * @param boot the member's present life; empty: it is not there, and the call fails
   */
  void begin(Call call, Optional<String> boot, RatsLink.CallListener listener) {
    begin(call, Optional.empty(), boot, listener);
  }

  /**
   * @param grace beyond t, for the member's exit strategy and its answer
   */
  void begin(
      Call call, Optional<Duration> grace, Optional<String> boot, RatsLink.CallListener listener) {
    begin(call, grace, boot, listener, this::send);
  }

  /**
   * The same for a call that was made before: it is not made again, but ended.
   *
   * @param cancelId of the call that ends it
   */
  void end(
      Call call,
      Optional<Duration> grace,
      Optional<String> boot,
      String cancelId,
      RatsLink.CallListener listener) {
    begin(call, grace, boot, listener, former -> haveEnded(former, boot, cancelId));
  }

  private void haveEnded(Open former, Optional<String> boot, String cancelId) {
    former.isToEnd = true;
    begin(
        cancelling(member(former.call), boot, former.call.id(), cancelId),
        boot,
        answer -> {
          if (Boolean.FALSE.equals(answer.values().get("found"))) {
            end(former, ErrorCode.CANCELED, member(former.call) + " is at no such call");
          }
        });
  }

  private void begin(
      Call call,
      Optional<Duration> grace,
      Optional<String> boot,
      RatsLink.CallListener listener,
      Consumer<Open> first) {
    Open begun = new Open(addressed(call, boot), grace.orElse(GRACE), listener);
    if (open.containsKey(call.id())) {
      String message = "A call of the id " + call.id() + " is under way; each call needs its own";
      Result refused = result(begun, Outcome.FAILED, ErrorCode.DUPLICATE_ID, message);
      afterwards(() -> listener.ended(refused));
      return;
    }
    open.put(call.id(), begun);
    Optional<Result> saidBefore = late.of(begun.call);
    if (saidBefore.isPresent()) {
      afterwards(() -> end(begun, saidBefore.get()));
    } else if (boot.isEmpty()) {
      String message = member(call) + " is not there";
      afterwards(() -> end(begun, ErrorCode.MEMBER_LOST, message));
    } else if (!begun.call.boot().equals(boot)) {
      String message = member(call) + " was started again since it was asked";
      afterwards(() -> end(begun, ErrorCode.RESTARTED, message));
    } else {
      begun.deadline = clock.now().plus(call.timeout());
      watch(begun, call.timeout());
      first.accept(begun);
    }
  }

  /** Not on the thread that calls, which may not expect its listener to be told meanwhile. */
  private void afterwards(Runnable action) {
    clock.schedule(Duration.ZERO, controller, action);
  }

  private Call addressed(Call call, Optional<String> boot) {
    return stamps.stamp(
        new Call(
            call.id(),
            call.member(),
            call.boot().or(() -> boot),
            call.feature(),
            call.parameters(),
            call.timeout(),
            call.from(),
            call.task(),
            call.expects()));
  }

  /** To whomever it concerns; nobody waits for what they answer. */
  void sendUnwatched(Call call) {
    publish(stamps.stamp(call), call.timeout(), failure -> failure.ifPresent(this::note));
  }

  void cancel(String callId, String cancelId) {
    Open call = open.get(callId);
    if (call != null) {
      call.cancelId = Optional.of(cancelId);
      if (call.established) {
        watch(call, CANCEL_LIMIT);
      }
      sendCancel(call);
    }
  }

  /** A call need not be among these: one of a former life of the controller may be meant. */
  void sendCancel(String member, Optional<String> boot, String callId, String cancelId) {
    sendUnwatched(cancelling(member, boot, callId, cancelId));
  }

  private Call cancelling(String member, Optional<String> boot, String callId, String cancelId) {
    return new Call(
        cancelId,
        Optional.of(member),
        boot,
        ReservedFeature.CANCEL.word(),
        Map.of("id", callId),
        CANCEL_LIMIT,
        controller,
        Optional.empty());
  }

  /**
   * Sends again what may have been lost with the connection; the member answers what it has
   * answered already.
   */
  void resume() {
    List.copyOf(open.values()).forEach(this::sendAgain);
  }

  /** The same for one member, which may have been away when the others were not. */
  void resume(String member) {
    List.copyOf(open.values()).stream()
        .filter(call -> member(call.call).equals(member))
        .forEach(this::sendAgain);
  }

  private void sendAgain(Open call) {
    send(call);
    sendCancel(call);
  }

  /** On the bare topic nobody is named but in the message itself. */
  void resultHeard(Message message) {
    Result result;
    try {
      result = wire.decodeResult(message.payload());
    } catch (MalformedMessageException malformed) {
      unreadable(message, malformed);
      throw malformed;
    }
    String sender = topics.senderOf(message.topic()).orElse(result.from());
    Open call = open.get(result.id());
    if (call != null && isFrom(call, sender, result.from())) {
      stamps.check(call.deadline, result);
      end(call, result);
    } else if (call == null) {
      late.heard(sender, result);
    }
  }

  /** Who has answered what nobody can read does not answer again. */
  private void unreadable(Message message, MalformedMessageException malformed) {
    Optional<Open> answered =
        wire.idOf(message.payload())
            .map(open::get)
            .filter(
                call ->
                    topics.senderOf(message.topic()).filter(member(call.call)::equals).isPresent());
    answered.ifPresent(
        call ->
            end(
                call,
                ErrorCode.INTERNAL,
                "%s gave an answer that cannot be read: %s"
                    .formatted(member(call.call), malformed.getMessage())));
  }

  void progressHeard(Message message) {
    Progress progress = wire.decodeProgress(message.payload());
    String sender = topics.senderOf(message.topic()).orElse(progress.from());
    Open call = open.get(progress.id());
    if (call == null || !isFrom(call, sender, progress.from())) {
      return;
    }
    if (progress.kind() == Progress.Kind.ESTABLISHED) {
      call.established = true;
      if (call.cancelId.isEmpty()) {
        call.timer.ifPresent(Clock.Timer::cancel);
      }
    } else if (!call.established && call.cancelId.isEmpty()) {
      watch(call, call.call.timeout());
    }
    call.listener.progressed(progress);
  }

  /** Returns whether it belongs to an open call. */
  boolean observed(String sender, Observation observation) {
    Open call = open.get(observation.id());
    if (call == null || !isFrom(call, sender, observation.from())) {
      return false;
    }
    call.listener.observed(observation);
    return true;
  }

  /** Somebody else could do what one of these asks for. */
  void offered(String sender, Offer offer) {
    Optional.ofNullable(open.get(offer.task()))
        .filter(call -> !member(call.call).equals(sender))
        .filter(call -> call.call.feature().equals(offer.feature()))
        .ifPresent(call -> call.listener.offered(sender, offer));
  }

  void released(String sender, Release release) {
    Optional.ofNullable(open.get(release.task()))
        .filter(call -> member(call.call).equals(sender))
        .ifPresent(call -> call.listener.released(release.reason()));
  }

  void memberGone(String member, String boot, String why) {
    failAll(call -> call.isAt(member, boot), ErrorCode.MEMBER_LOST, member + " was lost: " + why);
  }

  /** Whether one of them is at that life of the member. */
  boolean runsAt(String member, String boot) {
    return open.values().stream().anyMatch(call -> call.isAt(member, boot));
  }

  void closeAll() {
    failAll(call -> true, ErrorCode.BUS_UNAVAILABLE, "The link to the bus was closed");
  }

  private void failAll(Predicate<Open> which, ErrorCode code, String message) {
    new ArrayList<>(open.values()).stream().filter(which).forEach(call -> end(call, code, message));
  }

  private void send(Open call) {
    Duration left = call.established ? call.call.timeout() : call.deadline.minus(clock.now());
    if (call.isToEnd || left.isNegative() || left.isZero()) {
      return;
    }
    publish(
        call.call,
        left,
        failure ->
            failure.ifPresent(
                cause -> afterwards(() -> end(call, ErrorCode.BUS_UNAVAILABLE, reason(cause)))));
  }

  private static String reason(PublishException cause) {
    return Objects.requireNonNullElse(cause.getMessage(), cause.toString());
  }

  private void sendCancel(Open call) {
    call.cancelId.ifPresent(
        id -> sendCancel(member(call.call), call.call.boot(), call.call.id(), id));
  }

  private void publish(Call call, Duration left, Transport.Completion completion) {
    Duration expiry = Duration.ofMillis((long) Math.ceil(left.toMillis() / clock.speed()));
    transport.publish(
        Publication.reliable(topics.call(controller), wire.encode(call), Optional.of(expiry)),
        completion);
  }

  private void watch(Open call, Duration limit) {
    call.timer.ifPresent(Clock.Timer::cancel);
    call.timer =
        Optional.of(
            clock.schedule(
                limit.plus(call.grace).plus(clock.ofWall(WALL_GRACE)),
                controller,
                () ->
                    end(
                        call,
                        result(
                            call,
                            Outcome.TIMED_OUT,
                            ErrorCode.MEMBER_LOST,
                            member(call.call) + " gave no answer in time"))));
  }

  private void end(Open call, ErrorCode code, String message) {
    end(call, result(call, Outcome.FAILED, code, message));
  }

  private void end(Open call, Result result) {
    if (open.remove(call.call.id(), call)) {
      call.timer.ifPresent(Clock.Timer::cancel);
      if (result.error().filter(error -> error.code() == ErrorCode.MEMBER_LOST).isPresent()) {
        late.expect(call.call);
      }
      call.listener.ended(result);
    }
  }

  private static Result result(Open call, Outcome outcome, ErrorCode code, String message) {
    RatsError error =
        new RatsError(code, RatsError.Level.ERROR, message, Optional.empty(), List.of(), true);
    return new Result(
        call.call.id(), member(call.call), outcome, UNKNOWN_STATE, Map.of(), Optional.of(error));
  }

  private boolean isFrom(Open call, String sender, String from) {
    boolean right = sender.equals(member(call.call)) && from.equals(sender);
    if (!right && complaints.isDue(sender)) {
      LOG.warn("{} answers the call {} in the name of {}: ignored", sender, call.call.id(), from);
    }
    return right;
  }

  private static String member(Call call) {
    return call.member().orElseThrow();
  }

  private void note(PublishException failure) {
    LOG.debug("{}", failure.getMessage());
  }

  private static final class Open {
    private final Call call;
    private final Duration grace;
    private final RatsLink.CallListener listener;
    private Optional<Clock.Timer> timer = Optional.empty();
    private Duration deadline = Duration.ZERO;
    private Optional<String> cancelId = Optional.empty();
    private boolean established;
    private boolean isToEnd;

    private Open(Call call, Duration grace, RatsLink.CallListener listener) {
      this.call = call;
      this.grace = grace;
      this.listener = listener;
    }

    private boolean isAt(String member, String boot) {
      return member(call).equals(member) && call.boot().filter(boot::equals).isPresent();
    }
  }
}
