package org.maestro.hal.ros;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;

/**
 * What is asked of a server, in the words of rosbridge, put where it waits to be sent. Any thread
 * may call.
 */
final class RosOrders {

  private final RosVersion version;
  private final ObjectMapper json;
  private final Outbox outbox;

  RosOrders(RosVersion version, ObjectMapper json, Outbox outbox) {
    this.version = version;
    this.json = json;
    this.outbox = outbox;
  }

  /** To tell what comes on a topic: the last message only, where several wait. */
  void subscribe(String topic, RosTopic<?> listening) {
    put(
        order("subscribe", topic)
            .put("type", version.typeName(listening.type()))
            .put("throttle_rate", listening.pause().toMillis())
            .put("queue_length", 1));
  }

  /** To expect messages of that type. */
  void advertise(String topic, RosType type) {
    put(order("advertise", topic).put("type", version.typeName(type)));
  }

  /** To tell it to whoever listens there. */
  void publish(String topic, ObjectNode message) {
    ObjectNode order = order("publish", topic);
    order.set("msg", message);
    put(order);
  }

  /** Its id comes back with what the server says of it, see {@link #topicOf}. */
  private ObjectNode order(String operation, String topic) {
    return json.createObjectNode()
        .put("op", operation)
        .put("id", operation + ":" + topic)
        .put("topic", topic);
  }

  /** The topic of the order of that id. */
  static String topicOf(String id) {
    return id.substring(id.indexOf(':') + 1);
  }

  private void put(ObjectNode order) {
    try {
      outbox.put(order.path("id").asText(), json.writeValueAsString(order));
    } catch (JsonProcessingException impossible) {
      throw new IllegalStateException("An order cannot be written as JSON", impossible);
    }
  }
}
