package org.maestro.ontology.home;

import java.lang.ref.Reference;
import java.lang.ref.ReferenceQueue;
import java.lang.ref.WeakReference;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Devices that were read and that somebody still has: to read a description takes milliseconds, and
 * an agent and the knowledge read the same one. Safe for threads.
 */
final class ReadDevices {
  private final Map<Source, Kept> devices = new ConcurrentHashMap<>();
  private final ReferenceQueue<Device> gone = new ReferenceQueue<>();

  private record Source(String member, String text) {}

  private static final class Kept extends WeakReference<Device> {
    private final Source source;

    private Kept(Source source, Device device, ReferenceQueue<Device> gone) {
      super(device, gone);
      this.source = source;
    }
  }

  Optional<Device> find(String member, String text) {
    return Optional.ofNullable(devices.get(new Source(member, text))).map(WeakReference::get);
  }

  void keep(String member, String text, Device device) {
    for (Reference<? extends Device> old = gone.poll(); old != null; old = gone.poll()) {
      Kept kept = (Kept) old;
      devices.remove(kept.source, kept);
    }
    Source source = new Source(member, text);
    devices.put(source, new Kept(source, device, gone));
  }
}
