package org.maestro.deployment;

import java.util.Collections;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * The start of a container: for which topics, on what host, in which process.
 *
 * @param name in the platform
 * @param topics whose agents it is for
 * @param provides what its host has, such as {@code microphone} or {@code gpu}
 * @param own whether it is of the platform's own process
 * @param process in which it lives, if that is another one, as it tells of itself
 */
public record ContainerStart(
    String name,
    Set<String> topics,
    Set<String> provides,
    boolean own,
    Optional<ProcessStart> process) {
  public ContainerStart {
    topics = Collections.unmodifiableSet(new TreeSet<>(topics));
    provides = Collections.unmodifiableSet(new TreeSet<>(provides));
  }

  /** Of which nothing is known of the process. */
  public ContainerStart(String name, Set<String> topics, Set<String> provides, boolean own) {
    this(name, topics, provides, own, Optional.empty());
  }

  /** The same for more topics. */
  public ContainerStart with(Set<String> otherTopics) {
    return new ContainerStart(name, otherTopics, provides, own, process);
  }
}
