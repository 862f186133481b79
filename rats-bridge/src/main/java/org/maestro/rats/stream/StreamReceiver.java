package org.maestro.rats.stream;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.link.SiteKind;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Transport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One stream of a member, received by a controller of its own (ADE, 3.3; A44). Nothing streams
 * before it calls the member's feature, and nothing any more when it is closed or lost. Frames of
 * other calls are not its own. Any thread may close it; the listener is told on the clock's thread
 * and must hand over at once.
 */
public final class StreamReceiver implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(StreamReceiver.class);

  /** Simulated time in which a stream has to begin. */
  private static final Duration BEGINS_WITHIN = Duration.ofSeconds(15);

  private final Wanted wanted;
  private final String receiver;
  private final Clock clock;
  private final Listener listener;
  private final WireFormat wire = new WireFormat();
  private final Complaints complaints = new Complaints();
  private final CompletableFuture<Void> left = new CompletableFuture<>();
  private final RatsLink link;
  private Optional<RatsLink.CallHandle> call = Optional.empty();
  private long latest;
  private boolean isOver;

  /**
   * A stream of a member.
   *
   * @param feature that of the member that streams
   * @param parameters of the call
   */
  public record Wanted(String member, String feature, Map<String, Object> parameters) {}

  /**
   * A frame with what is known of its way.
   *
   * @param delay from its capture to its arrival, by the clocks of both sides: below zero when the
   *     member's is ahead
   * @param missed how many frames since the last one did not arrive
   */
  public record Received(StreamFrame frame, Duration delay, long missed) {}

  /** Told on the clock's thread. */
  public interface Listener {
    /** The member streams from now on. */
    default void began() {}

    void received(Received received);

    /**
     * Nothing follows.
     *
     * @param reason a sentence; empty when the stream came to its end by itself
     */
    void ended(Optional<String> reason);
  }

  private StreamReceiver(
      Wanted wanted, String receiver, RatsLink link, Clock clock, Listener listener) {
    this.wanted = wanted;
    this.receiver = receiver;
    this.link = link;
    this.clock = clock;
    this.listener = listener;
  }

  /**
   * Joins the site and begins the stream as soon as the member is there.
   *
   * @param transport not open yet, closed with this; its client id is the receiver's on open sites
   * @param receiver its id, under which it calls
   */
  public static StreamReceiver open(
      Wanted wanted,
      String receiver,
      String site,
      Transport transport,
      Clock clock,
      SiteKind kind,
      Listener listener) {
    Inlet inlet = new Inlet();
    transport.subscribe(
        new Topics(site).stream(wanted.member(), wanted.feature()),
        Transport.RetainedMessages.IGNORE,
        message -> clock.perform(receiver, () -> inlet.frames.accept(message)));
    RatsLink link = BusLink.connectForWatched(receiver, site, transport, clock, kind);
    StreamReceiver opened = new StreamReceiver(wanted, receiver, link, clock, listener);
    inlet.frames = opened::arrived;
    link.watch(wanted.member(), opened::changed);
    return opened;
  }

  private void changed(RatsLink.Member member) {
    if (call.isEmpty() && !isOver && member.phase() == MemberStatus.Phase.READY) {
      call =
          Optional.of(
              link.call(
                  wanted.member(),
                  wanted.feature(),
                  wanted.parameters(),
                  BEGINS_WITHIN,
                  Optional.empty(),
                  new Course()));
    }
  }

  private void arrived(Message message) {
    StreamFrame frame;
    try {
      frame = wire.decodeFrame(message.payload());
    } catch (MalformedMessageException malformed) {
      if (complaints.isDue(wanted.member())) {
        LOG.warn("On {}: {}; the frame is ignored", message.topic(), malformed.getMessage());
      }
      return;
    }
    boolean isOwn =
        frame.from().equals(wanted.member())
            && call.filter(own -> own.callId().equals(frame.id())).isPresent();
    if (isOwn && !isOver && frame.number() > latest) {
      long missed = frame.number() - latest - 1;
      latest = frame.number();
      listener.received(
          new Received(frame, Duration.between(frame.capturedAt(), clock.instant()), missed));
    }
  }

  private void over(Optional<String> reason) {
    if (!isOver) {
      isOver = true;
      listener.ended(reason);
    }
  }

  /** Subscribed to before there is anybody to take what comes. */
  private static final class Inlet {
    private volatile Consumer<Message> frames = message -> {};
  }

  private final class Course implements RatsLink.CallListener {
    @Override
    public void progressed(Progress progress) {
      if (progress.kind() == Progress.Kind.ESTABLISHED && !isOver) {
        listener.began();
      }
    }

    @Override
    public void ended(Result result) {
      over(
          result.outcome() == Outcome.SUCCEEDED
              ? Optional.empty()
              : Optional.of(
                  result.error().map(RatsError::message).orElse(result.outcome().name())));
    }
  }

  /**
   * Ends the stream, and begins to leave the site. On a broker outside this process its last turn
   * waits for the goodbye on the clock's thread, two seconds at most: it needs a clock of its own.
   */
  @Override
  public void close() {
    clock.perform(receiver, this::end);
  }

  /** Done once the site is left. */
  public CompletableFuture<Void> left() {
    return left;
  }

  private void end() {
    call.ifPresent(RatsLink.CallHandle::cancel);
    over(Optional.empty());
    // A turn later, when the cancel is out.
    clock.schedule(
        Duration.ZERO,
        receiver,
        () -> {
          link.close();
          left.complete(null);
        });
  }
}
