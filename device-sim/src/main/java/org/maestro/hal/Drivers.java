package org.maestro.hal;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The drivers of one device by their interface; a combined device has several (Three-layered
 * architecture, 3.2.1; M31). Immutable.
 */
public final class Drivers {

  private final Map<Class<?>, Object> byKind;

  private Drivers(Map<Class<?>, Object> byKind) {
    this.byKind = Collections.unmodifiableMap(byKind);
  }

  public static Drivers none() {
    return new Drivers(new LinkedHashMap<>());
  }

  public <T> Drivers with(Class<T> kind, T driver) {
    Map<Class<?>, Object> extended = new LinkedHashMap<>(byKind);
    extended.put(kind, driver);
    return new Drivers(extended);
  }

  public <T> Optional<T> find(Class<T> kind) {
    return Optional.ofNullable(kind.cast(byKind.get(kind)));
  }
}
