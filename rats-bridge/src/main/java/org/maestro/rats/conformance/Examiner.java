package org.maestro.rats.conformance;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** A caller on the bus that sends whatever it is told to, and keeps what it hears. */
final class Examiner implements AutoCloseable {

  /** Nobody else calls under these names. */
  static final String OTHER = "examiner-2";

  private static final int TIMEOUT_MILLIS = 5_000;

  private final Transport transport;
  private final Topics topics;
  private final String member;
  private final boolean isOpen;
  private final Patience patience;
  private final ObjectMapper json = new ObjectMapper();
  private final List<Heard> heard = new ArrayList<>();
  private final String run = Long.toHexString(System.nanoTime());
  private int calls;

  /** A message, and what stands in it; a payload that is no JSON is missing. */
  record Heard(String topic, JsonNode content, boolean isEmpty, boolean retained) {}

  /**
   * @param isOpen whether it may read what is for others
   */
  Examiner(Transport transport, Topics topics, String member, boolean isOpen, Patience patience) {
    this.transport = transport;
    this.topics = topics;
    this.member = member;
    this.isOpen = isOpen;
    this.patience = patience;
  }

  String name() {
    return transport.clientId();
  }

  /** Whether the broker lets it in. */
  boolean connects() {
    CompletableFuture<Boolean> there = new CompletableFuture<>();
    Stream.of(topics.status(member), topics.description(member), topics.state(member))
        .forEach(
            topic -> transport.subscribe(topic, Transport.RetainedMessages.SEND, this::arrived));
    Stream.of(topics.results(name()), topics.progresses(name()))
        .forEach(
            topic -> transport.subscribe(topic, Transport.RetainedMessages.SEND, this::arrived));
    if (isOpen) {
      Stream.of(topics.results(OTHER), topics.bareResult())
          .forEach(
              topic ->
                  transport.subscribe(topic, Transport.RetainedMessages.IGNORE, this::arrived));
    }
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            there.complete(true);
          }

          @Override
          public void lost(String reason) {}
        });
    try {
      return there.get(patience.appearsWithin().toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      return false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    } catch (ExecutionException e) {
      throw new IllegalStateException("An answer is never a failure", e);
    }
  }

  private void arrived(Message message) {
    JsonNode content;
    try {
      content = json.readTree(message.payload());
    } catch (IOException e) {
      content = json.missingNode();
    }
    synchronized (heard) {
      heard.add(
          new Heard(message.topic(), content, message.payload().length == 0, message.retained()));
      heard.notifyAll();
    }
  }

  /** How many messages have come by now; what comes later has higher numbers. */
  int now() {
    synchronized (heard) {
      return heard.size();
    }
  }

  /** The first such message since then; waits for it so long. */
  Optional<Heard> await(int since, Predicate<Heard> wanted, Duration atMost) {
    return awaitIn(() -> since(since).stream(), wanted, atMost);
  }

  /** The first such message that comes after one of the others; waits for it so long. */
  Optional<Heard> awaitAfter(
      int since, Predicate<Heard> others, Predicate<Heard> wanted, Duration atMost) {
    return awaitIn(() -> since(since).stream().dropWhile(others.negate()).skip(1), wanted, atMost);
  }

  private Optional<Heard> awaitIn(
      Supplier<Stream<Heard>> messages, Predicate<Heard> wanted, Duration atMost) {
    long end = System.nanoTime() + atMost.toNanos();
    synchronized (heard) {
      while (true) {
        Optional<Heard> found = messages.get().filter(wanted).findFirst();
        long left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
        if (found.isPresent() || left <= 0) {
          return found;
        }
        try {
          heard.wait(left);
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
          return Optional.empty();
        }
      }
    }
  }

  /**
   * What stands on the topic. What is told while the examiner is there comes without the retain
   * flag, whatever its sender wished: only the broker's answer to a question shows that it is kept.
   *
   * @return retained if it is; otherwise what was told there, if anything was
   */
  Optional<Heard> retained(String topic) {
    Predicate<Heard> told = heard -> heard.topic().equals(topic) && !heard.isEmpty();
    Optional<Heard> first = await(0, told, patience.appearsWithin());
    if (first.filter(Heard::retained).isPresent()) {
      return first;
    }
    transport.askForRetained(topic);
    return await(0, told.and(Heard::retained), patience.answersWithin()).or(() -> first);
  }

  /**
   * Whether the broker keeps this on the topic now. Two senders' messages may come in one order to
   * one receiver and in the other to another: what is kept is the last word.
   */
  boolean stands(String topic, JsonNode content) {
    int since = now();
    transport.askForRetained(topic);
    return await(
            since,
            heard ->
                heard.topic().equals(topic) && heard.retained() && heard.content().equals(content),
            patience.answersWithin())
        .isPresent();
  }

  /** Whether the broker keeps an answer of the device, which nobody who comes later asked for. */
  boolean isAnswerKept() {
    int since = now();
    transport.askForRetained(topics.results(name()));
    return await(
            since,
            heard ->
                heard.retained()
                    && topics.senderOf(heard.topic()).filter(member::equals).isPresent(),
            patience.silence())
        .isPresent();
  }

  List<Heard> since(int number) {
    synchronized (heard) {
      return List.copyOf(heard.subList(Math.min(number, heard.size()), heard.size()));
    }
  }

  String newId() {
    return "x" + run + "-" + ++calls;
  }

  /** A call of the member in version 1.0, with what else is said. */
  Map<String, Object> call(String id, String feature, Map<String, Object> parameters) {
    Map<String, Object> call = new LinkedHashMap<>();
    call.put("v", "1.0");
    call.put("id", id);
    call.put("r", member);
    call.put("f", feature);
    call.put("p", parameters);
    call.put("t", TIMEOUT_MILLIS);
    call.put("from", name());
    return call;
  }

  void send(Map<String, Object> call) {
    send(topics.call(name()), bytes(call));
  }

  void send(String topic, byte[] payload) {
    transport.publish(Publication.reliable(topic, payload, Optional.empty()), failure -> {});
  }

  void sendRetained(String topic, byte[] payload) {
    transport.publish(Publication.retained(topic, payload), failure -> {});
  }

  byte[] bytes(Map<String, Object> fields) {
    try {
      return json.writeValueAsBytes(fields);
    } catch (JsonProcessingException e) {
      throw new IllegalArgumentException("The call is no JSON", e);
    }
  }

  @Override
  public void close() {
    transport.close();
  }
}
