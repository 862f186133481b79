package org.maestro.rats.conformance;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URI;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** A bell that keeps all rules but those that its flaw breaks: what it tells and hears. */
final class FlawedDevice implements AutoCloseable {
  private static final String ID = "bell-1";
  private static final String BOOT = "b7";
  private static final String DESCRIPTION =
      "{\"id\":\"#bell-1\",\"offers\":[{\"id\":\"https://example.org/b#ring\"}]}";

  /** Calls of $ping after each other. */
  private static final int MANY = 50;

  private final Flaw flaw;
  private final Topics topics;
  private final Transport transport;
  private final ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor();
  private final ObjectMapper json = new ObjectMapper();
  private final FlawedCalls calls;
  private boolean isDead;
  private int pings;

  FlawedDevice(Flaw flaw, URI broker, String site) {
    this.flaw = flaw;
    this.topics = new Topics(site);
    this.transport = new PahoTransport(broker, ID);
    this.calls = new FlawedCalls(flaw, thread, this::announce, this::tellState, this::result);
    CompletableFuture<Boolean> there = new CompletableFuture<>();
    transport.subscribe(
        topics.calls(),
        Transport.RetainedMessages.IGNORE,
        message -> thread.execute(() -> heard(message)));
    transport.subscribeToOthers(
        topics.status(ID), message -> thread.execute(() -> saidOfMe(message)));
    transport.subscribeToOthers(
        topics.description(ID), message -> thread.execute(() -> describedByAnother(message)));
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            thread.execute(FlawedDevice.this::announce);
            thread.execute(() -> there.complete(true));
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
    tell(topics.description(ID), DESCRIPTION);
    tellState();
    tell(
        topics.status(ID),
        "{\"v\":\"1.0\",\"id\":\"bell-1\",\"status\":\"ready\",\"boot\":\"b7\"}");
  }

  private void tellState() {
    if (flaw != Flaw.TELLS_NO_STATE) {
      tell(
          topics.state(ID),
          "{\"v\":\"1.0\",\"id\":\"bell-1\",%s\"z\":\"standby\",\"values\":[],\"recent\":%s}"
              .formatted(
                  flaw == Flaw.TELLS_NO_BOOT_IN_ITS_STATE ? "" : "\"boot\":\"b7\",",
                  json.valueToTree(calls.recent())));
    }
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
    String said = new String(message.payload(), UTF_8);
    boolean isOther = !said.contains("\"" + BOOT + "\"");
    Flaw believed;
    if (said.isEmpty()) {
      believed = Flaw.BELIEVES_THAT_IT_IS_CLEARED;
    } else if (said.contains("disconnected")) {
      believed = Flaw.BELIEVES_THAT_IT_IS_DISCONNECTED;
    } else if (said.contains("lost")) {
      believed = isOther ? Flaw.BELIEVES_A_LATE_WILL : Flaw.BELIEVES_ITS_WILL;
    } else {
      isDead = isDead || isOther && flaw == Flaw.LEAVES_FOR_A_NAMESAKE;
      return;
    }
    if (flaw != believed) {
      announce();
    }
  }

  private void describedByAnother(Message message) {
    if (!new String(message.payload(), UTF_8).equals(DESCRIPTION)
        && flaw != Flaw.KEEPS_ANOTHERS_DESCRIPTION) {
      tell(topics.description(ID), DESCRIPTION);
    }
  }

  private void heard(Message message) {
    String text = new String(message.payload(), UTF_8);
    try {
      if (text.length() > 100 && text.contains("[[[[")) {
        isDead = isDead || flaw == Flaw.DIES_OF_DEPTH;
        return;
      }
      JsonNode call = json.readTree(text);
      if (!isDead && call.isObject() && isMeant(call, message)) {
        if (text.contains("\\ud800") && flaw != Flaw.TAKES_HALF_CHARACTERS) {
          calls.refuse(call, "MALFORMED", "p holds half a character");
        } else {
          take(call);
        }
      }
    } catch (IOException rubbish) {
      isDead = isDead || flaw == Flaw.DIES_OF_RUBBISH;
    }
  }

  private boolean isMeant(JsonNode call, Message message) {
    boolean bare = message.topic().endsWith("/call");
    boolean isToAll = call.path("r").isMissingNode();
    String from = call.path("from").asText();
    String feature = call.path("f").asText();
    pings = feature.equals("$ping") ? pings + 1 : 0;
    if (message.retained() && flaw != Flaw.TAKES_RETAINED_CALLS
        || bare && flaw == Flaw.DEAF_ON_THE_BARE_TOPIC
        || isToAll && flaw == Flaw.DEAF_WITHOUT_RECEIVER
        || isToAll && feature.equals("neverWas") && flaw != Flaw.TAKES_ALL_WITHOUT_RECEIVER
        || pings > MANY && flaw == Flaw.FAINTS_OF_MANY
        || !call.path("id").isTextual()
        || !call.path("f").isTextual()) {
      return false;
    }
    return (List.of("", ID).contains(call.path("r").asText()) || flaw == Flaw.ANSWERS_FOR_OTHERS)
        && (bare || message.topic().endsWith("/" + from) || flaw == Flaw.BELIEVES_ANY_SENDER);
  }

  private void take(JsonNode call) {
    String version = call.path("v").asText();
    boolean isMine =
        version.startsWith("1.") && (flaw != Flaw.WANTS_ITS_OWN_VERSION || version.equals("1.0"));
    if (!isMine && flaw != Flaw.TAKES_ANY_VERSION) {
      calls.refuse(call, "UNSUPPORTED_VERSION", "The version " + version + " is not mine");
    } else if (!call.path("t").isNumber()) {
      calls.refuse(
          call,
          "MALFORMED",
          flaw == Flaw.NAMES_NO_FIELD ? "Something is wrong" : "t must be a number");
    } else if (!call.path("boot").asText(BOOT).equals(BOOT) && flaw != Flaw.TAKES_ANY_BOOT) {
      calls.refuse(call, "RESTARTED", "another boot");
    } else {
      calls.take(call);
    }
  }

  private void result(JsonNode call, FlawedCalls.Answer answer) {
    Map<String, Object> result = new LinkedHashMap<>();
    result.put("v", "1.0");
    result.put("id", call.path("id").asText());
    result.put("from", ID);
    result.put("outcome", answer.outcome());
    result.put("z", "standby");
    result.put("values", answer.values());
    answer.error().ifPresent(it -> result.put("error", it));
    if (flaw == Flaw.RESULT_WITHOUT_STATE) {
      result.remove("z");
    }
    byte[] payload = json.valueToTree(result).toString().getBytes(UTF_8);
    String topic =
        flaw == Flaw.ANSWERS_ON_THE_BARE_TOPIC
            ? topics.bareResult()
            : topics.result(call.path("from").asText(), ID);
    transport.publish(
        flaw == Flaw.RETAINS_RESULTS
            ? Publication.retained(topic, payload)
            : Publication.reliable(topic, payload, Optional.empty()),
        failure -> {});
  }

  @Override
  public void close() {
    thread.shutdownNow();
    List.of(topics.status(ID), topics.description(ID), topics.state(ID))
        .forEach(topic -> transport.publish(Publication.clearing(topic), failure -> {}));
    List.of("examiner", Examiner.OTHER)
        .forEach(
            caller ->
                transport.publish(Publication.clearing(topics.result(caller, ID)), failure -> {}));
    transport.close();
  }
}
