package org.maestro.rats.transport;

import java.time.Duration;
import java.util.Optional;

/**
 * One client's connection to the bus. Any thread may call it and nothing blocks, except {@link
 * #close}. Subscribe first, then open: after each connect and reconnect all subscriptions stand
 * before {@link ConnectionListener#connected} is told, and no message is delivered before that.
 * Sessions are clean: what was published while the client was away is lost, apart from retained
 * messages.
 */
public interface Transport extends AutoCloseable {

  String clientId();

  /**
   * Subscribes for the life of the transport. The filters of one transport must not overlap, since
   * brokers differ in how often they then deliver.
   *
   * @param filter an MQTT topic filter
   * @param retained whether the messages that are retained now are wanted
   * @throws IllegalArgumentException when the filter is none of MQTT
   */
  void subscribe(String filter, RetainedMessages retained, MessageHandler handler);

  /**
   * The same for what other clients publish from now on: nothing of this client's own comes back to
   * it, and nothing retained is sent.
   */
  void subscribeToOthers(String filter, MessageHandler handler);

  /**
   * Asks the broker once more for what is retained under a subscription that wanted it, since a
   * broker may lose a retained message to a subscriber that comes at the very moment of its
   * publication (seen with Artemis). Nothing happens while there is no connection.
   *
   * @param filter as it was subscribed
   */
  void askForRetained(String filter);

  /** Starts to connect, and keeps connecting until closed. To be called once. */
  void open(Optional<Will> will, ConnectionListener listener);

  /**
   * Says goodbye as {@link #close} does, and connects again after a while. The listener hears of
   * the new connection only.
   *
   * @param pause wall time; in process: the clock's
   */
  void stayAway(Duration pause);

  /**
   * Publishes. The completion is told exactly once: when the broker has taken the message (QoS 0:
   * when it was sent), or why it was not. Nothing is kept for later while there is no connection.
   */
  void publish(Publication publication, Completion completion);

  /** Begins to say goodbye as {@link #close} does, and does not wait for it. */
  void leave();

  /**
   * Says goodbye: what was published before still leaves, the will does not. Waits at most about
   * two seconds.
   */
  @Override
  void close();

  /**
   * Vanishes without goodbye, as after a power cut: the broker publishes the will. For tests and
   * simulated faults.
   */
  void die();

  enum RetainedMessages {
    SEND,
    IGNORE
  }

  /** Told on the transport's thread (in process: the clock's); must hand over at once. */
  interface MessageHandler {
    void arrived(Message message);
  }

  /** Told on the transport's thread (in process: the clock's); must hand over at once. */
  interface ConnectionListener {
    void connected();

    /** The connection is gone, or could not be made; the transport tries again by itself. */
    void lost(String reason);
  }

  /**
   * Told on the transport's thread (in process: the clock's, or the publisher's when refused at
   * once).
   */
  interface Completion {
    /** Empty when the broker took the message. */
    void completed(Optional<PublishException> failure);
  }

  /**
   * The last will: a message that the broker publishes, retained at QoS 1, when the client
   * vanishes.
   */
  record Will(String topic, byte[] payload) {}
}
