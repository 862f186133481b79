package org.maestro.rats.conformance;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URI;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** A bell that keeps all rules but one. */
final class FlawedDevice implements AutoCloseable {
  private static final String ID = "bell-1";
  private static final String BOOT = "b7";

  /** What is wrong with it, and the rules that it breaks by that. */
  enum Flaw {
    NONE(),
    TELLS_NO_STATE(DeviceRule.TOPICS),
    RETAINS_NOTHING(DeviceRule.TOPICS),
    DEAF_ON_THE_BARE_TOPIC(DeviceRule.BARE_TOPIC),
    DEAF_WITHOUT_RECEIVER(DeviceRule.BLANK_RECEIVER),
    RESULT_WITHOUT_STATE(DeviceRule.RESULT),
    BELIEVES_ANY_SENDER(DeviceRule.SENDER),
    DOES_TWICE(DeviceRule.SAME_CALL),
    TAKES_ANY_BODY(DeviceRule.OTHER_BODY),
    TAKES_ANY_BOOT(DeviceRule.OTHER_BOOT),
    TAKES_RETAINED_CALLS(DeviceRule.RETAINED_CALL),
    FINDS_WHAT_NEVER_WAS(DeviceRule.CANCEL),
    IS_NEVER_SAFE(DeviceRule.SAFE),
    PRICES_ONE_SET(DeviceRule.COST),
    PRICES_SLOWLY(DeviceRule.PRICE_IN_TIME),
    DESCRIBES_NOTHING_AGAIN(DeviceRule.PING_AND_DESCRIBE),
    BELIEVES_ITS_WILL(DeviceRule.OWN_WILL, DeviceRule.CLEARED_STATUS),
    WANTS_ITS_OWN_VERSION(DeviceRule.LATER_MINOR),
    TAKES_ANY_VERSION(DeviceRule.OTHER_MAJOR),
    DIES_OF_DEPTH(DeviceRule.TOO_BIG),
    NAMES_NO_FIELD(DeviceRule.NAMED_FIELD);

    private final List<DeviceRule> breaks;

    Flaw(DeviceRule... breaks) {
      this.breaks = List.of(breaks);
    }

    List<DeviceRule> breaks() {
      return breaks;
    }
  }

  private final Flaw flaw;
  private final Topics topics;
  private final Transport transport;
  private final ObjectMapper json = new ObjectMapper();
  private final Map<String, JsonNode> bodies = new HashMap<>();
  private final Map<String, byte[]> answers = new HashMap<>();
  private boolean isDead;
  private int rung;

  FlawedDevice(Flaw flaw, URI broker, String site) {
    this.flaw = flaw;
    this.topics = new Topics(site);
    this.transport = new PahoTransport(broker, ID);
    CompletableFuture<Boolean> there = new CompletableFuture<>();
    transport.subscribe(topics.calls(), Transport.RetainedMessages.IGNORE, this::heard);
    transport.subscribe(topics.status(ID), Transport.RetainedMessages.IGNORE, this::saidOfMe);
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            announce();
            there.complete(true);
          }

          @Override
          public void lost(String reason) {}
        });
    there.join();
  }

  String id() {
    return ID;
  }

  private void announce() {
    tell(
        topics.description(ID),
        "{\"id\":\"#bell-1\",\"offers\":[{\"id\":\"https://example.org/b#ring\"}]}");
    if (flaw != Flaw.TELLS_NO_STATE) {
      tell(
          topics.state(ID),
          "{\"v\":\"1.0\",\"id\":\"bell-1\",\"boot\":\"b7\",\"z\":\"standby\",\"values\":[],\"running\":[],\"queue\":[],\"disabled\":[]}");
    }
    tell(
        topics.status(ID),
        "{\"v\":\"1.0\",\"id\":\"bell-1\",\"status\":\"ready\",\"boot\":\"b7\"}");
  }

  private void tell(String topic, String text) {
    byte[] payload = text.getBytes(UTF_8);
    transport.publish(
        flaw == Flaw.RETAINS_NOTHING
            ? Publication.reliable(topic, payload, Optional.empty())
            : Publication.retained(topic, payload),
        failure -> {});
  }

  private void saidOfMe(Message message) {
    boolean isGone =
        message.payload().length == 0 || new String(message.payload(), UTF_8).contains("lost");
    if (isGone && flaw != Flaw.BELIEVES_ITS_WILL) {
      announce();
    }
  }

  private void heard(Message message) {
    try {
      if (message.payload().length > 100 && new String(message.payload(), UTF_8).contains("[[[[")) {
        isDead = flaw == Flaw.DIES_OF_DEPTH;
        return;
      }
      JsonNode call = json.readTree(message.payload());
      if (!isDead && call.isObject() && isMeant(call, message)) {
        take(call);
      }
    } catch (IOException rubbish) {
      // It costs nothing.
    }
  }

  private boolean isMeant(JsonNode call, Message message) {
    boolean bare = message.topic().endsWith("/call");
    String from = call.path("from").asText();
    if (message.retained() && flaw != Flaw.TAKES_RETAINED_CALLS
        || bare && flaw == Flaw.DEAF_ON_THE_BARE_TOPIC
        || call.path("r").isMissingNode() && flaw == Flaw.DEAF_WITHOUT_RECEIVER
        || !call.path("id").isTextual()
        || !call.path("f").isTextual()) {
      return false;
    }
    return List.of("", ID).contains(call.path("r").asText())
        && (bare || message.topic().endsWith("/" + from) || flaw == Flaw.BELIEVES_ANY_SENDER);
  }

  private void take(JsonNode call) throws IOException {
    String key = call.path("from").asText() + " " + call.path("id").asText();
    String version = call.path("v").asText();
    boolean isMine =
        version.startsWith("1.") && (flaw != Flaw.WANTS_ITS_OWN_VERSION || version.equals("1.0"));
    if (!isMine && flaw != Flaw.TAKES_ANY_VERSION) {
      refuse(call, "UNSUPPORTED_VERSION", "The version " + version + " is not mine");
    } else if (!call.path("t").isNumber()) {
      refuse(
          call,
          "MALFORMED",
          flaw == Flaw.NAMES_NO_FIELD ? "Something is wrong" : "t must be a number");
    } else if (!call.path("boot").asText(BOOT).equals(BOOT) && flaw != Flaw.TAKES_ANY_BOOT) {
      refuse(call, "RESTARTED", "another boot");
    } else if (bodies.containsKey(key)
        && !bodies.get(key).equals(call.path("p"))
        && flaw != Flaw.TAKES_ANY_BODY) {
      refuse(call, "DUPLICATE_ID", "another body");
    } else if (answers.containsKey(key) && flaw != Flaw.DOES_TWICE) {
      send(call, answers.get(key));
    } else {
      bodies.put(key, call.path("p"));
      perform(call, key);
    }
  }

  private void perform(JsonNode call, String key) throws IOException {
    Map<String, Object> values = new LinkedHashMap<>();
    switch (call.path("f").asText()) {
      case "ring" -> values.put("times", ++rung);
      case "$cancel" -> values.put("found", flaw == Flaw.FINDS_WHAT_NEVER_WAS);
      case "$describe" -> {
        if (flaw != Flaw.DESCRIBES_NOTHING_AGAIN) {
          announce();
        }
      }
      case "$cost" -> {
        pause();
        Map<String, Object> price = Map.of("cost", 1, "seconds", 1);
        values.put("costs", flaw == Flaw.PRICES_ONE_SET ? List.of(price) : List.of(price, price));
      }
      case "$safe" -> {
        if (flaw == Flaw.IS_NEVER_SAFE) {
          refuse(call, "DISABLED", "never");
          return;
        }
      }
      default -> {
        // Nothing is asked for.
      }
    }
    byte[] answer = result(call, "SUCCEEDED", values, Optional.empty());
    answers.put(key, answer);
    send(call, answer);
  }

  /** Real slowness, which the examiner is to see. */
  private void pause() {
    if (flaw == Flaw.PRICES_SLOWLY) {
      try {
        Thread.sleep(150);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private void refuse(JsonNode call, String code, String message) throws IOException {
    Map<String, Object> error =
        Map.of(
            "code",
            code,
            "level",
            "WARNING",
            "message",
            message,
            "refs",
            List.of(),
            "retriable",
            false);
    send(call, result(call, "REJECTED", Map.of(), Optional.of(error)));
  }

  private byte[] result(
      JsonNode call,
      String outcome,
      Map<String, Object> values,
      Optional<Map<String, Object>> error)
      throws IOException {
    Map<String, Object> result = new LinkedHashMap<>();
    result.put("v", "1.0");
    result.put("id", call.path("id").asText());
    result.put("from", ID);
    result.put("outcome", outcome);
    result.put("z", "standby");
    result.put("values", values);
    error.ifPresent(it -> result.put("error", it));
    if (flaw == Flaw.RESULT_WITHOUT_STATE) {
      result.remove("z");
    }
    return json.writeValueAsBytes(result);
  }

  private void send(JsonNode call, byte[] result) {
    transport.publish(
        Publication.reliable(
            topics.result(call.path("from").asText(), ID), result, Optional.empty()),
        failure -> {});
  }

  @Override
  public void close() {
    List.of(topics.status(ID), topics.description(ID), topics.state(ID))
        .forEach(topic -> transport.publish(Publication.clearing(topic), failure -> {}));
    transport.close();
  }
}
