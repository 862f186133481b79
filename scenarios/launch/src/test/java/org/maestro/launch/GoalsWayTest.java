package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.jdi.Bootstrap;
import com.sun.jdi.ClassType;
import com.sun.jdi.Method;
import com.sun.jdi.ReferenceType;
import com.sun.jdi.VMDisconnectedException;
import com.sun.jdi.VirtualMachine;
import com.sun.jdi.connect.Connector;
import com.sun.jdi.connect.LaunchingConnector;
import com.sun.jdi.event.BreakpointEvent;
import com.sun.jdi.event.ClassPrepareEvent;
import com.sun.jdi.event.Event;
import com.sun.jdi.event.EventSet;
import com.sun.jdi.event.VMDisconnectEvent;
import com.sun.jdi.request.BreakpointRequest;
import com.sun.jdi.request.ClassPrepareRequest;
import com.sun.jdi.request.EventRequest;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/**
 * A debugger's trace of the demo's first goal through coordination, agents and members: the classes
 * that it passes on its way out to a device, and those that a result passes on its way back.
 * Whoever follows a goal through the code has to read that many.
 */
@Isolated("a debugger slows a whole platform down")
@Tag("full")
@Tag("once")
class GoalsWayTest {
  private static final List<String> ROOMS = List.of("coordination", "agents", "members");

  @Test
  void aGoalPassesFewClassesOnItsWayOutAndBack() throws Exception {
    Way way = Way.traced(System.getProperty("java.class.path"), Maestro.class.getName() + " demo");
    System.out.printf(
        "A goal passes %d classes out, %d back%nout: %s%nback: %s%n",
        way.out.size(), way.back.size(), way.out, way.back);
    assertThat(way.out).hasSizeBetween(50, 140);
    assertThat(way.back).hasSizeBetween(40, 140);
  }

  /** The trace. */
  static final class Way {
    private final Set<String> out = new TreeSet<>();
    private final Set<String> back = new TreeSet<>();
    private final Map<ReferenceType, List<BreakpointRequest>> armed = new HashMap<>();
    private Leg leg = Leg.BEFORE;

    private enum Leg {
      BEFORE,
      OUT,
      ORDERED,
      BACK,
      OVER
    }

    static Way traced(String classPath, String command) throws Exception {
      LaunchingConnector connector = Bootstrap.virtualMachineManager().defaultConnector();
      Map<String, Connector.Argument> arguments = connector.defaultArguments();
      arguments.get("main").setValue(command);
      arguments
          .get("options")
          .setValue("-Xmx1g -XX:+UseSerialGC -Djava.awt.headless=true -cp \"" + classPath + "\"");
      VirtualMachine machine = connector.launch(arguments);
      drain(machine.process().getInputStream());
      drain(machine.process().getErrorStream());
      Way way = new Way();
      try {
        way.follow(machine);
      } catch (VMDisconnectedException over) {
        // It ended of its own accord.
      } finally {
        machine.process().destroyForcibly().waitFor();
      }
      return way;
    }

    private static void drain(InputStream text) {
      Thread thread =
          new Thread(
              () -> {
                try (text) {
                  text.transferTo(OutputStream.nullOutputStream());
                } catch (IOException closed) {
                  // So it ends.
                }
              });
      thread.setDaemon(true);
      thread.start();
    }

    private void follow(VirtualMachine machine) throws InterruptedException {
      ROOMS.forEach(room -> prepare(machine, "org.maestro." + room + ".*"));
      prepare(machine, "org.maestro.device.*");
      machine.resume();
      while (leg != Leg.OVER) {
        EventSet events = machine.eventQueue().remove();
        for (Event event : events) {
          if (event instanceof VMDisconnectEvent) {
            return;
          } else if (event instanceof ClassPrepareEvent prepared) {
            arm(machine, prepared.referenceType());
          } else if (event instanceof BreakpointEvent reached) {
            entered(machine, reached.location().method(), isSignOfLife(reached.thread().name()));
          }
        }
        events.resume();
      }
      machine.exit(0);
    }

    private static void prepare(VirtualMachine machine, String classes) {
      ClassPrepareRequest request = machine.eventRequestManager().createClassPrepareRequest();
      request.addClassFilter(classes);
      request.enable();
    }

    /** Stops at the class once, wherever it is entered first. */
    private void arm(VirtualMachine machine, ReferenceType type) {
      if (armed.containsKey(type) || !(isOnTheWay(type) || isMark(type))) {
        return;
      }
      List<BreakpointRequest> requests = new ArrayList<>();
      for (Method method : type.methods()) {
        if (!method.isAbstract() && !method.isNative() && method.location() != null) {
          BreakpointRequest request =
              machine.eventRequestManager().createBreakpointRequest(method.location());
          request.setSuspendPolicy(EventRequest.SUSPEND_EVENT_THREAD);
          request.enable();
          requests.add(request);
        }
      }
      armed.put(type, requests);
    }

    private void armAll(VirtualMachine machine) {
      machine.allClasses().stream()
          .filter(ReferenceType::isPrepared)
          .forEach(type -> arm(machine, type));
    }

    private static boolean isMark(ReferenceType type) {
      String name = simple(type);
      return type.name().startsWith("org.maestro.device.")
          || name.equals("GoalRequest")
          || name.equals("GoalOutcome");
    }

    /** Containers and agents tell that they live, whatever else they do. */
    private static boolean isSignOfLife(String thread) {
      return thread.startsWith("maestro-pulse") || thread.endsWith("-failure-monitor");
    }

    private void entered(VirtualMachine machine, Method method, boolean signOfLife) {
      ReferenceType type = method.declaringType();
      String name = simple(type);
      Leg before = leg;
      if (leg == Leg.BEFORE && name.equals("GoalRequest")) {
        leg = Leg.OUT;
      } else if (leg == Leg.OUT && name.startsWith("Acl") && method.name().equals("perform")) {
        leg = Leg.ORDERED;
      } else if (leg == Leg.ORDERED && type.name().startsWith("org.maestro.device.")) {
        leg = Leg.BACK;
      } else if (leg == Leg.BACK && name.equals("GoalOutcome")) {
        leg = Leg.OVER;
      }
      // What a platform does as it starts is on no goal's way.
      if (leg != Leg.BEFORE && !signOfLife && isOnTheWay(type)) {
        (leg == Leg.BACK ? back : out).add(name);
      }
      boolean isResult = leg == Leg.BACK && name.equals("CallReporter");
      if (isResult && method.name().equals("ended")) {
        back.clear();
        back.add(name);
      }
      if (!isResult && !(leg == Leg.OUT && name.startsWith("Acl"))) {
        machine.eventRequestManager().deleteEventRequests(armed.getOrDefault(type, List.of()));
        armed.put(type, List.of());
      }
      if (leg != before || isResult) {
        armed.values().removeIf(List::isEmpty);
        armAll(machine);
      }
    }

    private static boolean isOnTheWay(ReferenceType type) {
      return ROOMS.stream().anyMatch(room -> type.name().startsWith("org.maestro." + room + "."))
          && type instanceof ClassType known
          && !known.isEnum()
          && !"java.lang.Record"
              .equals(known.superclass() == null ? "" : known.superclass().name());
    }

    /** Of a nested class, the one that it stands in. */
    private static String simple(ReferenceType type) {
      String name = type.name().substring(type.name().lastIndexOf('.') + 1);
      return name.contains("$") ? name.substring(0, name.indexOf('$')) : name;
    }
  }
}
