package org.maestro.hal;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * A thing that a camera looks for or a gripper takes.
 *
 * @param name local name of the thing
 * @param properties what is known of its looks and shape, by the property's name
 */
public record Target(String name, Map<String, Object> properties) {
  public Target {
    properties = Collections.unmodifiableMap(new TreeMap<>(properties));
  }
}
