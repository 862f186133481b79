package org.maestro.platform.guard;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import com.sun.management.ThreadMXBean;
import jade.core.AID;
import jade.core.Agent;
import jade.lang.acl.ACLMessage;
import jade.tools.DummyAgent.DummyAgent;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Hashtable;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.TreeMap;
import java.util.Vector;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.event.EventListenerList;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import net.jqwik.api.lifecycle.AfterContainer;
import net.jqwik.api.lifecycle.BeforeContainer;
import org.maestro.agents.GenericAgent;
import org.maestro.agents.device.Surroundings;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.deployment.AgentStart;
import org.maestro.fixtures.Gadgets;
import org.maestro.platform.BareJade;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.time.SteppedClock;

/** Which agents may arrive from another container, and how long one that is none takes at most. */
class ArrivalTest {
  private static final Duration BOUND = Duration.ofSeconds(5);

  /** Several times what an agent takes, and as much as a packet may be long. */
  private static final long MOST_BYTES = 1 << 20;

  /** Ways to put something into something else, in one of which gadgets begin. */
  private static final List<UnaryOperator<Object>> SHAPES =
      List.of(
          inner -> new HashSet<>(Set.of(inner, new Object[] {inner})),
          inner -> new LinkedHashSet<>(List.of(inner, "beside")),
          inner -> new Vector<>(List.of(inner, inner)),
          inner -> new Hashtable<>(Map.of(inner, inner)),
          inner -> new HashMap<>(Map.of(inner, "value")),
          inner -> new ConcurrentHashMap<>(Map.of(inner, "value")),
          inner -> new ArrayList<>(List.of(inner, inner)),
          inner -> new Object[] {inner, inner},
          inner -> new TreeMap<>(Map.of("key", inner)),
          inner -> new PriorityQueue<>(Arrays.asList("one", "two")),
          inner -> new File("/"),
          inner -> new EventListenerList());

  private static BareJade jade;

  @BeforeContainer
  static void start() throws IOException {
    jade = new BareJade("arrivals", Files.createTempDirectory("maestro-arrivals"));
  }

  @AfterContainer
  static void end() throws IOException {
    jade.close();
    try (Stream<Path> left = Files.walk(jade.files())) {
      left.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
    }
  }

  /** One that has not begun anywhere. */
  private static GenericAgent agent() {
    Surroundings here =
        new Surroundings(
            AgentTime.of(new SteppedClock()),
            (RatsLink)
                Proxy.newProxyInstance(
                    ArrivalTest.class.getClassLoader(),
                    new Class<?>[] {RatsLink.class},
                    (proxy, method, arguments) -> {
                      throw new AssertionError("It does not act: " + method);
                    }),
            (description, member) -> {
              throw new AssertionError("It reads nothing: " + description);
            });
    return new GenericAgent(jade.birth(), here, AgentStart.of("lamp-1", "lights"));
  }

  @Example
  void aGenericAgentArrives() throws Exception {
    assertThat(Arrival.of(Gadgets.bytes(agent()))).isInstanceOf(GenericAgent.class);
  }

  @Example
  void anotherAgentOfThisProcessDoesNot() throws Exception {
    for (Agent other : List.of(new Agent(), new DummyAgent())) {
      byte[] bytes = Gadgets.bytes(other);
      assertThatThrownBy(() -> Arrival.of(bytes)).isInstanceOf(IOException.class);
    }
  }

  @Example
  void whatIsNoAgentDoesNot() throws Exception {
    for (Object other : List.of("text", new AID("rose@home", AID.ISGUID), new ACLMessage(1))) {
      byte[] none = Gadgets.bytes(other);
      assertThatThrownBy(() -> Arrival.of(none))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("it is no generic agent");
    }
  }

  @Example
  void aNestOfSetsTakesNoTime() throws Exception {
    Object root = Gadgets.nest(32);
    refusedInTime(Gadgets.bytes(root));
    refusedInTime(Gadgets.bytes(new Object[] {"before", root}));
  }

  @Example
  void whatContainsItselfIsRefused() throws Exception {
    Vector<Object> endless = new Vector<>();
    endless.add(endless);
    refusedInTime(Gadgets.bytes(endless));
  }

  @Property(tries = 200)
  void gadgetsOfAnyShapeAreRefusedInTime(@ForAll("shapes") List<UnaryOperator<Object>> shapes)
      throws Exception {
    Object gadget = "inmost";
    for (UnaryOperator<Object> shape : shapes) {
      gadget = shape.apply(gadget);
    }
    refusedInTime(Gadgets.bytes(gadget));
  }

  @Provide
  Arbitrary<List<UnaryOperator<Object>>> shapes() {
    return Arbitraries.of(SHAPES).list().ofMinSize(1).ofMaxSize(14);
  }

  @Property(tries = 500)
  void anAgentWithOtherBytesInItIsReadOrRefusedInTime(
      @ForAll @Size(min = 1, max = 8) List<@IntRange(min = 0, max = 1_000_000) Integer> places,
      @ForAll byte other)
      throws Exception {
    byte[] changed = Gadgets.bytes(agent());
    for (int place : places) {
      changed[place % changed.length] = other;
    }
    inTime(changed);
  }

  @Example
  void noNumberInAnAgentMakesItTakeMuchMemory() throws Exception {
    byte[] agent = Gadgets.bytes(agent());
    for (int place = 0; place + Integer.BYTES <= agent.length; place++) {
      for (int number : new int[] {10_000_000, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
        byte[] changed = agent.clone();
        ByteBuffer.wrap(changed).putInt(place, number);
        assertThat(allocatedFor(changed))
            .as("for %d at %d of %d", number, place, agent.length)
            .isLessThan(MOST_BYTES);
      }
    }
  }

  @Example
  void noOtherSpellingOfAFieldDoes() throws Exception {
    GenericAgent agent = agent();
    agent.setEnabledO2ACommunication(true, 10_000);
    byte[] plain = Gadgets.bytes(agent);
    assertThat(Arrival.of(plain)).isInstanceOf(GenericAgent.class);

    byte[] spelt =
        new String(plain, ISO_8859_1)
            .replace("\0\14o2aQueueSize", "\0\15\u00c1\u00af2aQueueSize")
            .getBytes(ISO_8859_1);
    assertThat(spelt).hasSize(plain.length + 1);
    assertThatThrownBy(() -> Arrival.of(spelt))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("places for objects of other programs");
  }

  private static long allocatedFor(byte[] bytes) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();
    isRead(bytes);
    return threads.getCurrentThreadAllocatedBytes() - before;
  }

  private static void refusedInTime(byte[] bytes) {
    assertThat(inTime(bytes)).as("arrives").isFalse();
  }

  /** Whether it arrives; nothing but what refuses an agent may be thrown. */
  private static boolean inTime(byte[] bytes) {
    return assertTimeoutPreemptively(BOUND, () -> isRead(bytes));
  }

  private static boolean isRead(byte[] bytes) {
    try {
      return Arrival.of(bytes) != null;
    } catch (IOException | ClassNotFoundException | RuntimeException refused) {
      return false;
    }
  }
}
