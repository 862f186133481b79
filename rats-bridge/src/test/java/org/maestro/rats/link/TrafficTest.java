package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Schemas;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** What link and members really send, against the AsyncAPI document and the JSON Schemas. */
class TrafficTest {

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Schemas schemas = new Schemas();
  private final List<Message> heard = new ArrayList<>();

  @Test
  void isAsTheDocumentsSay() throws IOException {
    client("witness").subscribe("rats/1/home/#", Transport.RetainedMessages.SEND, heard::add);
    live();
    JsonNode document = Schemas.document("asyncapi.json");
    Map<String, String> reservedByCall = new TreeMap<>();
    TreeSet<String> used = new TreeSet<>();
    for (Message message : heard) {
      String channel = channel(document, message.topic());
      used.add(channel);
      JsonNode operation = operation(document, channel);
      assertThat(message.retained())
          .as(message.topic())
          .isEqualTo(operation.at("/bindings/mqtt/retain").asBoolean());
      boolean clears = message.retained() && message.payload().length == 0;
      if (!clears && !channel.equals("description")) {
        JsonNode payload = MAPPER.readTree(message.payload());
        assertThat(schemas.faults(schema(document, channel), payload))
            .as("%s %s", message.topic(), payload)
            .isEmpty();
        reserved(reservedByCall, payload);
      }
    }
    assertThat(used)
        .containsExactlyInAnyOrder(
            "call",
            "result",
            "progress",
            "status",
            "description",
            "state",
            "observation",
            "controllerStatus");
    assertThat(reservedByCall.values()).contains("$cost", "$cancel", "$safe", "$describe", "$ping");
  }

  @Test
  void mayUseThePapersBareTopics() {
    RatsLink link = BusLink.connect("cca", "home", bus.client("cca"), clock);
    Transport device = client("lamp");
    device.subscribe(
        "rats/1/home/call/#",
        Transport.RetainedMessages.IGNORE,
        call -> {
          try {
            JsonNode read = MAPPER.readTree(call.payload());
            if (read.path("r").asText().equals("lamp")) {
              publish(
                  device,
                  "rats/1/home/result",
                  "{\"v\":\"1.0\",\"id\":\"%s\",\"from\":\"lamp\",\"outcome\":\"SUCCEEDED\",\"z\":\"on\"}"
                      .formatted(read.get("id").asText()));
            }
          } catch (IOException unreadable) {
            throw new IllegalStateException(unreadable);
          }
        });
    clock.run(Duration.ofSeconds(1));
    device.publish(
        Publication.retained(
            "rats/1/home/member/lamp/status",
            "{\"v\":\"1.0\",\"id\":\"lamp\",\"status\":\"ready\",\"boot\":\"1\"}".getBytes()),
        failure -> {});
    clock.run(Duration.ofSeconds(1));
    List<Result> results = new ArrayList<>();
    link.call("lamp", "shine", Map.of(), Duration.ofSeconds(5), Optional.empty(), results::add);
    clock.run(Duration.ofSeconds(1));
    assertThat(results).extracting(Result::from).containsExactly("lamp");
    TestDevice anna = new TestDevice("anna", clock);
    RatsMember.start(anna.profile(), List::of, bus.client("anna"), "home", clock);
    clock.run(Duration.ofSeconds(1));
    publish(
        device,
        "rats/1/home/call",
        "{\"v\":\"1.0\",\"id\":\"1\",\"r\":\"anna\",\"f\":\"echo\",\"t\":1000,\"from\":\"tim\"}");
    clock.run(Duration.ofSeconds(1));
    assertThat(anna.log).hasSize(1);
  }

  private void live() {
    RatsMember anna =
        RatsMember.start(
            new TestDevice("anna", clock).profile(),
            () -> List.of("(level lamp 0)"),
            bus.client("anna"),
            "home",
            clock);
    RatsLink link = BusLink.connect("cca", "home", bus.client("cca"), clock);
    clock.run(Duration.ofSeconds(1));
    call(link, "echo", Map.of("a", List.of(1, true, "x")));
    call(link, "broken", Map.of());
    call(link, "drive", Map.of());
    call(link, "grip", Map.of());
    call(link, "wave", Map.of());
    call(link, "fly", Map.of());
    call(link, "$ping", Map.of());
    RatsLink.CallHandle watch = call(link, "watch", Map.of("object", "Cup"));
    link.cost("anna", "drive", List.of(Map.of("to", "a"), Map.of()), prices -> {});
    clock.run(Duration.ofSeconds(20));
    watch.cancel();
    call(link, "drive", Map.of("to", "a"));
    clock.run(Duration.ofSeconds(1));
    link.safe();
    clock.run(Duration.ofSeconds(20));
    anna.close();
    link.close();
    clock.run(Duration.ofSeconds(1));
  }

  private static RatsLink.CallHandle call(
      RatsLink link, String feature, Map<String, Object> parameters) {
    return link.call(
        "anna", feature, parameters, Duration.ofSeconds(10), Optional.of("G1"), result -> {});
  }

  /** What calls of reserved features carry there and back. */
  private void reserved(Map<String, String> reservedByCall, JsonNode payload) {
    String id = payload.get("id").asText();
    String feature = payload.path("f").asText();
    if (feature.startsWith("$")) {
      reservedByCall.put(id, feature);
      assertThat(
              schemas.faults("reserved.json#/$defs/" + feature + "-parameters", payload.get("p")))
          .as("%s", payload)
          .isEmpty();
    } else if (payload.path("outcome").asText().equals("SUCCEEDED")
        && reservedByCall.containsKey(id)) {
      assertThat(
              schemas.faults(
                  "reserved.json#/$defs/" + reservedByCall.get(id) + "-values",
                  payload.get("values")))
          .as("%s", payload)
          .isEmpty();
    }
  }

  private static String channel(JsonNode document, String topic) {
    for (Map.Entry<String, JsonNode> channel : document.get("channels").properties()) {
      String address = channel.getValue().get("address").asText();
      if (topic.matches(address.replace("{site}", "home").replaceAll("\\{[a-z]+}", "[^/]+"))) {
        return channel.getKey();
      }
    }
    throw new AssertionError("No channel of the AsyncAPI document has the topic " + topic);
  }

  private static JsonNode operation(JsonNode document, String channel) {
    for (JsonNode operation : document.get("operations")) {
      if (operation.at("/channel/$ref").asText().equals("#/channels/" + channel)) {
        return operation;
      }
    }
    throw new AssertionError("No operation of the AsyncAPI document has the channel " + channel);
  }

  private static String schema(JsonNode document, String channel) {
    JsonNode messages = document.at("/channels/" + channel + "/messages");
    String name = messages.fieldNames().next();
    String file = document.at("/components/messages/" + name + "/payload/schema/$ref").asText();
    return file.substring("./".length());
  }

  private Transport client(String id) {
    Transport client = bus.client(id);
    client.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            // What it hears is what counts here.
          }

          @Override
          public void lost(String reason) {
            throw new AssertionError(reason);
          }
        });
    return client;
  }

  private static void publish(Transport transport, String topic, String text) {
    transport.publish(
        Publication.reliable(topic, text.getBytes(), Optional.of(Duration.ofSeconds(10))),
        failure -> {});
  }
}
