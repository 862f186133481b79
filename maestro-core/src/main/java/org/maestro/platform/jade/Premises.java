package org.maestro.platform.jade;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.maestro.platform.hosts.HostStart;

/**
 * The surroundings of a platform's process: where others reach it, what its machine provides, and
 * which other hosts it may start processes on.
 *
 * @param host an address of this machine, on which containers listen for each other
 * @param letters where messages of agents on other platforms come in; empty: there they are not
 *     heard, and nobody here writes to them
 * @param provides what agents of this process find here, such as {@code microphone} or {@code
 *     memory 512}
 * @param hosts whose processes are started, and started again when they have died
 */
public record Premises(
    String host, Optional<LetterBox> letters, Set<String> provides, List<HostStart> hosts) {
  static final String LOOPBACK = "127.0.0.1";

  public Premises {
    provides = Set.copyOf(provides);
    hosts = List.copyOf(hosts);
  }

  /**
   * @param host an address of this machine
   * @param port 0 for a free one
   */
  public record LetterBox(String host, int port) {
    /** As FIPA writes it, and other platforms are told. */
    public String url() {
      return "http://%s:%d/acc".formatted(host, port);
    }
  }

  /** Of a process that other processes of this machine reach, and no other platform. */
  public static Premises usual() {
    return new Premises(LOOPBACK, Optional.empty(), Set.of(), List.of());
  }

  /** The same on another address of this machine. */
  public Premises on(String address) {
    return new Premises(address, letters, provides, hosts);
  }

  /** The same, which agents of other platforms can write to. */
  public Premises with(Optional<LetterBox> box) {
    return new Premises(host, box, provides, hosts);
  }

  /** The same, with hosts whose processes are started. */
  public Premises starting(List<HostStart> others) {
    return new Premises(host, letters, provides, others);
  }

  /** The same, where agents find more. */
  public Premises providing(Set<String> words) {
    return new Premises(host, letters, words, hosts);
  }
}
