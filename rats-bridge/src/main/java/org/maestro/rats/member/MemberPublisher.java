package org.maestro.rats.member;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.Release;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.PublishException;
import org.maestro.rats.transport.Transport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * All that a member publishes. Results that could not be sent are sent again after the next
 * connect. Any thread.
 */
final class MemberPublisher {

  private static final Logger LOG = LoggerFactory.getLogger(MemberPublisher.class);
  private static final int MOST_UNSENT = 256;
  private static final Duration HOLDER_TIMEOUT = Duration.ofSeconds(30);
  private static final Duration CALL_EXPIRY = Duration.ofSeconds(30);

  private final String id;
  private final String boot;
  private final String description;
  private final Topics topics;
  private final Transport transport;
  private final WireFormat wire = new WireFormat();
  private final Deque<Publication> unsent = new ArrayDeque<>();
  private final AtomicLong ownCalls = new AtomicLong();
  private final Complaints complaints = new Complaints();
  private boolean silent;

  MemberPublisher(MemberProfile profile, String boot, Topics topics, Transport transport) {
    this.id = profile.id();
    this.boot = boot;
    this.description = profile.description();
    this.topics = topics;
    this.transport = transport;
  }

  Transport.Will will() {
    return new Transport.Will(topics.status(id), statusBytes(MemberStatus.Phase.LOST));
  }

  void status(MemberStatus.Phase phase) {
    publish(Publication.retained(topics.status(id), statusBytes(phase)));
  }

  void description() {
    publish(Publication.retained(topics.description(id), description.getBytes(UTF_8)));
  }

  boolean isDescription(byte[] payload) {
    return Arrays.equals(payload, description.getBytes(UTF_8));
  }

  void state(MemberState state) {
    encoded("its state", () -> wire.encode(state))
        .ifPresent(bytes -> publish(Publication.retained(topics.state(id), bytes)));
  }

  /** An outcome that cannot be sent is told as a failure: every call gets an answer. */
  void result(String to, Result result) {
    byte[] bytes;
    try {
      bytes = wire.encode(result);
    } catch (IllegalArgumentException unsendable) {
      String why = Objects.requireNonNullElse(unsendable.getMessage(), unsendable.toString());
      bytes = wire.encode(unsendable(result, why));
    }
    sendResult(Publication.reliable(topics.result(to, id), bytes, Optional.empty()));
  }

  private static Result unsendable(Result result, String why) {
    RatsError error =
        new RatsError(
            ErrorCode.INTERNAL,
            RatsError.Level.ERROR,
            "It ended (%s), and what came of it cannot be sent: %s"
                .formatted(result.outcome(), why),
            Optional.empty(),
            List.of(),
            false);
    return new Result(
        result.id(), result.from(), Outcome.FAILED, result.state(), Map.of(), Optional.of(error));
  }

  void progress(String to, Progress progress) {
    encoded("progress", () -> wire.encode(progress))
        .ifPresent(
            bytes ->
                publish(Publication.reliable(topics.progress(to, id), bytes, Optional.empty())));
  }

  void observation(Observation observation) {
    encoded("what it observes", () -> wire.encode(observation))
        .ifPresent(
            bytes ->
                publish(Publication.stream(topics.observation(id, observation.feature()), bytes)));
  }

  /**
   * @param over is run once it has left, or cannot
   */
  void frame(StreamFrame frame, Runnable over) {
    Optional<byte[]> bytes = encoded("a frame", () -> wire.encode(frame));
    if (bytes.isEmpty() || silent()) {
      over.run();
      return;
    }
    publish(
        Publication.stream(topics.stream(id, frame.feature()), bytes.get()),
        failure -> {
          logged(failure);
          over.run();
        });
  }

  /** What cannot be sent is passed over, and complained of now and then. */
  private Optional<byte[]> encoded(String what, Supplier<byte[]> encoder) {
    try {
      return Optional.of(encoder.get());
    } catch (IllegalArgumentException unsendable) {
      if (complaints.isDue(id)) {
        LOG.warn("{} cannot tell {}: {}", id, what, unsendable.getMessage());
      }
      return Optional.empty();
    }
  }

  /**
   * Something that people should hear of at once, and that must not get lost when there is no
   * connection just now.
   */
  void alert(String callId, String message) {
    Observation alert =
        new Observation(callId, id, ReservedFeature.ALERT, Map.of("message", message));
    sendResult(
        Publication.stream(topics.observation(id, ReservedFeature.ALERT), wire.encode(alert)));
  }

  /** Tells the call's holder that the task comes back, before the outcome does. */
  void release(Call call, String reason) {
    tellHolder(call, ReservedFeature.RELEASE, new Release(call.id(), reason).parameters());
  }

  /** Tells the holder of what another is at that this member could do it too. */
  void offer(Call call, Offer offer) {
    tellHolder(call, ReservedFeature.OFFER, offer.parameters());
  }

  private void tellHolder(Call call, String feature, Map<String, Object> parameters) {
    Call told =
        new Call(
            nextCallId(),
            Optional.of(call.from()),
            Optional.empty(),
            feature,
            parameters,
            HOLDER_TIMEOUT,
            id,
            call.task());
    call(told);
  }

  /** No other call of the member has it. */
  String nextCallId() {
    return id + "-" + boot + "-" + ownCalls.incrementAndGet();
  }

  /** Of the member's own. */
  void call(Call call) {
    publish(Publication.reliable(topics.call(id), wire.encode(call), Optional.of(CALL_EXPIRY)));
  }

  void sendUnsent() {
    List<Publication> again;
    synchronized (this) {
      again = new ArrayList<>(unsent);
      unsent.clear();
    }
    again.forEach(this::sendResult);
  }

  /**
   * Clears all that is retained; nothing else is published from then on, not even when the member
   * hears at once that it was cleared.
   */
  synchronized void leave() {
    if (!silent) {
      silent = true;
      List.of(topics.state(id), topics.description(id), topics.status(id))
          .forEach(topic -> transport.publish(Publication.clearing(topic), this::logged));
    }
  }

  synchronized void silence() {
    silent = true;
  }

  synchronized boolean silent() {
    return silent;
  }

  private void sendResult(Publication publication) {
    publish(
        publication,
        failure -> {
          if (failure.isPresent()) {
            keep(publication);
          }
        });
  }

  private synchronized void keep(Publication publication) {
    if (unsent.size() >= MOST_UNSENT) {
      unsent.removeFirst();
      LOG.warn("{} gives up its oldest result that could not be sent", id);
    }
    unsent.addLast(publication);
  }

  private void publish(Publication publication) {
    publish(publication, this::logged);
  }

  private synchronized void publish(Publication publication, Transport.Completion completion) {
    if (!silent) {
      transport.publish(publication, completion);
    }
  }

  private void logged(Optional<PublishException> failure) {
    failure.ifPresent(cause -> LOG.debug("{}: {}", id, cause.getMessage()));
  }

  private byte[] statusBytes(MemberStatus.Phase phase) {
    return wire.encode(new MemberStatus(id, phase, boot));
  }
}
