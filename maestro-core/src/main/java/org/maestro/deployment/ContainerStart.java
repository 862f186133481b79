package org.maestro.deployment;

import java.util.Collections;
import java.util.Set;
import java.util.TreeSet;

/**
 * How a container was started.
 *
 * @param name in the platform
 * @param topics whose agents it is for
 * @param provides what its host has, such as {@code microphone} or {@code gpu}
 * @param own whether it is of the platform's own process
 */
public record ContainerStart(String name, Set<String> topics, Set<String> provides, boolean own) {
  public ContainerStart {
    topics = Collections.unmodifiableSet(new TreeSet<>(topics));
    provides = Collections.unmodifiableSet(new TreeSet<>(provides));
  }
}
