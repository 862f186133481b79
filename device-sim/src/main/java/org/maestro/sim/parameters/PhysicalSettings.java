package org.maestro.sim.parameters;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.maestro.sim.scene.SimulationException;

/**
 * {@link PhysicalParameters} by name: {@code world.camera.noise}, {@code world.shutters}; each part
 * and each number of it has the name that its source states.
 */
public final class PhysicalSettings {

  private static final String WORLD = "world";

  private PhysicalSettings() {}

  /** All names with their present values, in the order in which the sources are stated. */
  public static Map<String, String> of(PhysicalParameters parameters) {
    Map<String, String> settings = new LinkedHashMap<>();
    collect(WORLD, parameters, settings);
    return Collections.unmodifiableMap(settings);
  }

  /**
   * The same parameters with other values.
   *
   * @throws SimulationException when a name is unknown, which then lists what is known, or when a
   *     value makes no sense
   */
  public static PhysicalParameters apply(
      PhysicalParameters parameters, Map<String, String> settings) {
    Map<String, String> known = of(parameters);
    for (String name : settings.keySet()) {
      if (!known.containsKey(name)) {
        throw new SimulationException(
            "There is no setting %s; there are %s."
                .formatted(name, String.join(", ", known.keySet())));
      }
    }
    return (PhysicalParameters) changed(WORLD, parameters, settings);
  }

  /**
   * Reads {@code name=value}.
   *
   * @throws SimulationException when it is something else
   */
  public static Map.Entry<String, String> parse(String text) {
    int equals = text.indexOf('=');
    if (equals <= 0 || equals == text.length() - 1) {
      throw new SimulationException(
          "A setting reads name=value, such as world.camera.noise=0.05, not \"%s\"."
              .formatted(text));
    }
    return Map.entry(text.substring(0, equals).strip(), text.substring(equals + 1).strip());
  }

  /** What each of them is, by its name, in the same order. */
  public static Map<String, Quantity> quantities() {
    Map<String, Quantity> quantities = new LinkedHashMap<>();
    describe(WORLD, PhysicalParameters.class, quantities);
    return Collections.unmodifiableMap(quantities);
  }

  private static void describe(String name, Class<?> group, Map<String, Quantity> quantities) {
    for (RecordComponent part : group.getRecordComponents()) {
      String whole = name + "." + part.getName();
      Quantity quantity = part.getAnnotation(Quantity.class);
      if (quantity == null) {
        describe(whole, part.getType(), quantities);
      } else {
        quantities.put(whole, quantity);
      }
    }
  }

  private static void collect(String name, Object value, Map<String, String> settings) {
    if (value instanceof Record group) {
      for (RecordComponent part : group.getClass().getRecordComponents()) {
        collect(name + "." + part.getName(), read(part, group), settings);
      }
    } else if (value instanceof List<?> list) {
      settings.put(name, list.stream().map(String::valueOf).collect(Collectors.joining(",")));
    } else {
      settings.put(name, String.valueOf(value));
    }
  }

  private static Object changed(String name, Object value, Map<String, String> settings) {
    if (value instanceof Record group) {
      Object[] parts =
          Arrays.stream(group.getClass().getRecordComponents())
              .map(part -> changed(name + "." + part.getName(), read(part, group), settings))
              .toArray();
      return made(group.getClass(), parts);
    }
    return settings.containsKey(name) ? parsed(name, value, settings.get(name)) : value;
  }

  private static Object parsed(String name, Object former, String text) {
    try {
      if (former instanceof Boolean) {
        if (!text.equals("true") && !text.equals("false")) {
          throw wrong(name, text, "true or false");
        }
        return text.equals("true");
      }
      if (former instanceof Integer) {
        return natural(name, Integer.parseInt(text.strip()));
      }
      if (former instanceof List<?>) {
        return Arrays.stream(text.split(","))
            .map(part -> natural(name, Integer.parseInt(part.strip())))
            .toList();
      }
      double number = Double.parseDouble(text);
      if (!Double.isFinite(number) || number < 0) {
        throw wrong(name, text, "a number from 0 on");
      }
      return number;
    } catch (NumberFormatException e) {
      throw wrong(
          name, text, former instanceof Double ? "a number from 0 on" : "a whole number from 0 on");
    }
  }

  private static int natural(String name, int number) {
    if (number < 0) {
      throw wrong(name, String.valueOf(number), "a whole number from 0 on");
    }
    return number;
  }

  private static SimulationException wrong(String name, String text, String kind) {
    return new SimulationException("The setting %s is %s, not \"%s\".".formatted(name, kind, text));
  }

  private static Object read(RecordComponent part, Record group) {
    try {
      return part.getAccessor().invoke(group);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("A record's part can be read: " + part, e);
    }
  }

  private static Object made(Class<?> group, Object[] parts) {
    Class<?>[] types =
        Arrays.stream(group.getRecordComponents())
            .map(RecordComponent::getType)
            .toArray(Class<?>[]::new);
    try {
      Constructor<?> constructor = group.getDeclaredConstructor(types);
      return constructor.newInstance(parts);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof SimulationException meaningless) {
        throw meaningless;
      }
      throw new IllegalStateException("A record can be made of its parts: " + group, e);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("A record can be made of its parts: " + group, e);
    }
  }
}
