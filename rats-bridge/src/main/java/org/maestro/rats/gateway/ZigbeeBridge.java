package org.maestro.rats.gateway;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.function.Function;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Presents the lamps of a zigbee2mqtt broker as members of a RATS site (Three-layered architecture,
 * 4.3; M89): each light of its retained device list, for as long as it is on that list. Topics and
 * payloads are those that zigbee2mqtt publishes since version 1.17. Any thread may close it.
 */
public final class ZigbeeBridge implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(ZigbeeBridge.class);
  private static final String OWNER = "zigbee";
  private static final Duration LIST_COMES_WITHIN = Duration.ofSeconds(2);
  private static final Duration ASKS_FOR_LIST_AT_LEAST_EVERY = Duration.ofMinutes(1);

  private final String base;
  private final Transport zigbee;
  private final Site site;
  private final LampRole role;
  private final Clock clock;
  private final ObjectMapper json = new ObjectMapper();
  private final Complaints complaints = new Complaints();
  private final Map<String, LampMember> byAddress = new ConcurrentSkipListMap<>();
  private final Map<String, JsonNode> saidByName = new LinkedHashMap<>();
  private final Map<String, Boolean> onlineByName = new LinkedHashMap<>();
  private final Insistence askingForList;
  private boolean bridgeOnline = true;
  private volatile boolean closed;

  /**
   * The site that the members join.
   *
   * @param transports one for each member, by id; not open yet
   */
  public record Site(String name, Function<String, Transport> transports, CallPolicy policy) {}

  private ZigbeeBridge(String base, Transport zigbee, Site site, LampRole role, Clock clock) {
    this.base = base;
    this.zigbee = zigbee;
    this.site = site;
    this.role = role;
    this.clock = clock;
    this.askingForList =
        new Insistence(
            OWNER,
            () -> zigbee.askForRetained(all()),
            LIST_COMES_WITHIN,
            ASKS_FOR_LIST_AT_LEAST_EVERY,
            clock);
  }

  /**
   * Listens to the gateway; lamps join as it tells of them.
   *
   * @param base zigbee2mqtt's base topic, usually {@code zigbee2mqtt}
   * @param zigbee to its broker, not open yet; closed with the bridge
   */
  public static ZigbeeBridge start(
      String base, Transport zigbee, Site site, LampRole role, Clock clock) {
    ZigbeeBridge bridge = new ZigbeeBridge(base, zigbee, site, role, clock);
    bridge.open();
    return bridge;
  }

  /** The lamps leave the site; waits some seconds at most for what they say last. */
  @Override
  public void close() {
    closed = true;
    clock.schedule(Duration.ZERO, OWNER, askingForList::end);
    byAddress.values().forEach(LampMember::leave);
    byAddress.clear();
    zigbee.close();
  }

  private void open() {
    zigbee.subscribe(
        all(),
        Transport.RetainedMessages.SEND,
        message -> clock.schedule(Duration.ZERO, OWNER, () -> heard(message)));
    zigbee.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            clock.schedule(Duration.ZERO, OWNER, () -> connection(true));
          }

          @Override
          public void lost(String reason) {
            clock.schedule(Duration.ZERO, OWNER, () -> connection(false));
          }
        });
  }

  private String all() {
    return base + "/#";
  }

  private void connection(boolean stands) {
    askingForList.end();
    if (stands) {
      askingForList.beginAfterPause();
    } else {
      saidByName.clear();
    }
    bridge(stands);
  }

  private void heard(Message message) {
    String topic = message.topic().substring(base.length() + 1);
    if (topic.endsWith("/set") || topic.endsWith("/get") || message.payload().length == 0) {
      return;
    }
    try {
      if (topic.equals("bridge/devices")) {
        devices(json.readTree(message.payload()));
      } else if (topic.equals("bridge/state")) {
        bridge(isOnline(message));
      } else if (topic.endsWith("/availability")) {
        String name = topic.substring(0, topic.length() - "/availability".length());
        onlineByName.put(name, isOnline(message));
        named(name).ifPresent(this::tellReachable);
      } else if (!topic.startsWith("bridge/")) {
        JsonNode said = json.readTree(message.payload());
        saidByName.put(topic, said);
        named(topic).ifPresent(lamp -> lamp.heard(said));
      }
    } catch (IOException unreadable) {
      if (complaints.isDue(topic)) {
        LOG.warn("The gateway's message on {} is no JSON and is ignored", message.topic());
      }
    }
  }

  /** Both the present form, an object, and the former one, a bare word. */
  private boolean isOnline(Message message) throws IOException {
    String text = new String(message.payload(), UTF_8);
    return text.startsWith("{")
        ? json.readTree(text).path("state").asText().equals("online")
        : text.equals("online");
  }

  private void devices(JsonNode list) {
    askingForList.end();
    Map<String, ZigbeeLamp> present = new LinkedHashMap<>();
    list.forEach(
        device -> ZigbeeLamp.of(device).ifPresent(lamp -> present.put(lamp.address(), lamp)));
    for (LampMember known : List.copyOf(byAddress.values())) {
      if (!known.lamp().equals(present.get(known.lamp().address()))) {
        byAddress.remove(known.lamp().address());
        known.leave();
      }
    }
    present.values().stream()
        .filter(lamp -> !byAddress.containsKey(lamp.address()))
        .forEach(this::join);
  }

  private void join(ZigbeeLamp lamp) {
    role.id(lamp)
        .ifPresent(
            id -> {
              LampMember member =
                  LampMember.start(
                      lamp,
                      id,
                      role,
                      gateway(lamp),
                      site.transports().apply(id),
                      site.name(),
                      site.policy(),
                      complaints,
                      clock);
              byAddress.put(lamp.address(), member);
              if (closed) {
                member.leave();
              }
              Optional.ofNullable(saidByName.get(lamp.name())).ifPresent(member::heard);
              tellReachable(member);
            });
  }

  private LampMember.Gateway gateway(ZigbeeLamp lamp) {
    String topic = base + "/" + lamp.name();
    return new LampMember.Gateway() {
      @Override
      public void set(JsonNode order) {
        publish(topic + "/set", order);
      }

      @Override
      public void ask() {
        publish(topic + "/get", json.createObjectNode().put("state", ""));
      }
    };
  }

  private void publish(String topic, JsonNode payload) {
    try {
      zigbee.publish(
          Publication.reliable(topic, json.writeValueAsBytes(payload), Optional.empty()),
          failure -> failure.ifPresent(cause -> LOG.debug("{}", cause.getMessage())));
    } catch (JsonProcessingException impossible) {
      throw new IllegalStateException("An order cannot be written as JSON", impossible);
    }
  }

  private void bridge(boolean online) {
    bridgeOnline = online;
    byAddress.values().forEach(this::tellReachable);
  }

  private void tellReachable(LampMember member) {
    String name = member.lamp().name();
    if (!bridgeOnline) {
      member.reachable(Optional.of("the ZigBee gateway is away"));
    } else if (!onlineByName.getOrDefault(name, true)) {
      member.reachable(Optional.of("the lamp " + name + " cannot be reached by ZigBee"));
    } else {
      member.reachable(Optional.empty());
    }
  }

  private Optional<LampMember> named(String name) {
    return byAddress.values().stream()
        .filter(member -> member.lamp().name().equals(name))
        .findFirst();
  }
}
