package org.maestro.rats.member;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Release;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Result;
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
final class MemberVoice {

  private static final Logger LOG = LoggerFactory.getLogger(MemberVoice.class);
  private static final int MOST_UNSENT = 256;
  private static final Duration HOLDER_TIMEOUT = Duration.ofSeconds(30);

  private final String id;
  private final String boot;
  private final String description;
  private final Topics topics;
  private final Transport transport;
  private final WireFormat wire = new WireFormat();
  private final Deque<Publication> unsent = new ArrayDeque<>();
  private final AtomicLong holderCalls = new AtomicLong();
  private boolean silent;

  MemberVoice(MemberProfile profile, String boot, Topics topics, Transport transport) {
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

  void state(MemberState state) {
    publish(Publication.retained(topics.state(id), wire.encode(state)));
  }

  void result(String to, Result result) {
    sendResult(Publication.reliable(topics.result(to, id), wire.encode(result), Optional.empty()));
  }

  void progress(String to, Progress progress) {
    publish(Publication.reliable(topics.progress(to, id), wire.encode(progress), Optional.empty()));
  }

  void observation(Observation observation) {
    publish(
        Publication.stream(
            topics.observation(id, observation.feature()), wire.encode(observation)));
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
            id + "-" + boot + "-" + holderCalls.incrementAndGet(),
            Optional.of(call.from()),
            Optional.empty(),
            feature,
            parameters,
            HOLDER_TIMEOUT,
            id,
            call.task());
    publish(Publication.reliable(topics.call(id), wire.encode(told), Optional.of(HOLDER_TIMEOUT)));
  }

  void sendUnsent() {
    List<Publication> again;
    synchronized (this) {
      again = new ArrayList<>(unsent);
      unsent.clear();
    }
    again.forEach(this::sendResult);
  }

  /** Clears all that is retained; then nothing is published any more. */
  synchronized void leave() {
    if (!silent) {
      publish(Publication.clearing(topics.state(id)));
      publish(Publication.clearing(topics.description(id)));
      publish(Publication.clearing(topics.status(id)));
      silent = true;
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
