package org.maestro.rats.gateway;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** Speaks as zigbee2mqtt does: a retained list of devices, states, availability, set and get. */
final class SimulatedGateway {

  private static final Duration RADIO = Duration.ofMillis(80);

  final Map<String, ObjectNode> lamps = new LinkedHashMap<>();
  final Set<String> deaf = new TreeSet<>();
  final List<String> orders = new ArrayList<>();

  /** When it was asked for a lamp's state. */
  final Map<String, List<Duration>> questions = new TreeMap<>();

  /** So many of the next questions get lost, as before its own subscription stands. */
  int missing;

  private final ObjectMapper json = new ObjectMapper();
  private final ArrayNode devices = json.createArrayNode();
  private final Transport transport;
  private final Clock clock;

  SimulatedGateway(Transport transport, Clock clock) {
    this.transport = transport;
    this.clock = clock;
    ObjectNode coordinator = devices.addObject();
    coordinator.put("ieee_address", "0x00124b0000000000").put("friendly_name", "Coordinator");
    coordinator.put("type", "Coordinator").putNull("definition");
  }

  void dimmable(String address, String name) {
    light(address, name, true);
  }

  void switched(String address, String name) {
    light(address, name, false);
  }

  private void light(String address, String name, boolean dimmable) {
    ArrayNode exposes = device(address, name);
    ArrayNode features = exposes.addObject().put("type", "light").putArray("features");
    features
        .addObject()
        .put("type", "binary")
        .put("name", "state")
        .put("property", "state")
        .put("value_on", "ON")
        .put("value_off", "OFF")
        .put("access", 7);
    if (dimmable) {
      features
          .addObject()
          .put("type", "numeric")
          .put("name", "brightness")
          .put("property", "brightness")
          .put("value_min", 0)
          .put("value_max", 254)
          .put("access", 7);
    }
    lamps.put(name, json.createObjectNode().put("state", "OFF").put("brightness", 254));
    if (!dimmable) {
      lamps.get(name).remove("brightness");
    }
  }

  void sensor(String address, String name) {
    device(address, name).addObject().put("type", "numeric").put("property", "temperature");
  }

  private ArrayNode device(String address, String name) {
    ObjectNode device = devices.addObject();
    device.put("ieee_address", address).put("friendly_name", name).put("type", "Router");
    device.put("supported", true).put("disabled", false);
    return device.putObject("definition").put("vendor", "Philips").putArray("exposes");
  }

  void remove(String name) {
    for (int index = 0; index < devices.size(); index++) {
      if (devices.get(index).get("friendly_name").asText().equals(name)) {
        devices.remove(index);
      }
    }
    publish("bridge/devices", devices, true);
  }

  void start() {
    transport.subscribe(
        "zigbee2mqtt/#", Transport.RetainedMessages.IGNORE, message -> heard(message));
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            publish("bridge/state", json.createObjectNode().put("state", "online"), true);
            publish("bridge/devices", devices, true);
          }

          @Override
          public void lost(String reason) {
            throw new AssertionError(reason);
          }
        });
  }

  void availability(String name, String state) {
    publish(name + "/availability", json.createObjectNode().put("state", state), true);
  }

  void bridgeState(String state) {
    publish("bridge/state", json.createObjectNode().put("state", state), true);
  }

  /** Somebody presses the lamp's own switch. */
  void byHand(String name, String state) {
    lamps.get(name).put("state", state);
    publish(name, lamps.get(name), false);
  }

  void garbage(String name) {
    transport.publish(
        Publication.reliable("zigbee2mqtt/" + name, "{no json".getBytes(UTF_8), Optional.empty()),
        failure -> {});
  }

  private void heard(Message message) {
    String topic = message.topic().substring("zigbee2mqtt/".length());
    int slash = topic.lastIndexOf('/');
    String name = slash < 0 ? topic : topic.substring(0, slash);
    if (topic.endsWith("/set") && lamps.containsKey(name)) {
      orders.add(name + " " + new String(message.payload(), UTF_8));
      if (!deaf.contains(name)) {
        clock.schedule(RADIO, name, () -> applied(name, tree(message.payload())));
      }
    } else if (topic.endsWith("/get") && lamps.containsKey(name)) {
      questions.computeIfAbsent(name, lamp -> new ArrayList<>()).add(clock.now());
      if (missing > 0) {
        missing--;
      } else {
        clock.schedule(RADIO, name, () -> publish(name, lamps.get(name), false));
      }
    }
  }

  private void applied(String name, JsonNode order) {
    order.properties().forEach(field -> lamps.get(name).set(field.getKey(), field.getValue()));
    lamps.get(name).put("linkquality", 120);
    publish(name, lamps.get(name), false);
  }

  private JsonNode tree(byte[] payload) {
    try {
      return json.readTree(payload);
    } catch (IOException unreadable) {
      throw new UncheckedIOException(unreadable);
    }
  }

  private void publish(String topic, JsonNode payload, boolean retained) {
    byte[] bytes = payload.toString().getBytes(UTF_8);
    transport.publish(
        retained
            ? Publication.retained("zigbee2mqtt/" + topic, bytes)
            : Publication.reliable("zigbee2mqtt/" + topic, bytes, Optional.empty()),
        failure -> {});
  }
}
