package org.maestro.ontology.home;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * All permissions that a home states for callers to ask for features; what may be read is told by
 * {@link PrivateWords}, which parts of agents may be used by {@link PartList}, and what persons may
 * by {@link PersonalPermission}. Where it states none everybody may ask everything; else what none
 * of them allows is refused. Immutable.
 *
 * @param permissions empty: everything is allowed
 */
public record AccessList(List<Permission> permissions) {
  public AccessList {
    permissions = List.copyOf(permissions);
  }

  public static AccessList of(Home home) {
    return new AccessList(
        home.individuals().values().stream()
            .filter(thing -> thing.classes().contains("Permission"))
            .filter(stated -> !PersonalPermission.isOne(stated))
            .map(Permission::of)
            .filter(permission -> !permission.isOfNoFeature())
            .toList());
  }

  public boolean isOpen() {
    return permissions.isEmpty();
  }

  /** The permissions that speak of this device; open only when the whole list is. */
  public List<Permission> about(Device device) {
    return permissions.stream().filter(permission -> permission.isAbout(device)).toList();
  }

  /** Whether the caller may ask anybody for anything. */
  public boolean knows(Set<String> caller) {
    return isOpen() || permissions.stream().anyMatch(permission -> permission.isFor(caller));
  }

  /**
   * Why the device does not do this for the caller.
   *
   * @param caller all names by which the caller is known
   * @return empty when it may be asked
   */
  public Optional<String> objection(Set<String> caller, Device device, String feature) {
    return isOpen() ? Optional.empty() : objection(about(device), caller, device.id(), feature);
  }

  /** The same, when only what speaks of the device is known. */
  public static Optional<String> objection(
      List<Permission> aboutDevice, Set<String> caller, String device, String feature) {
    boolean allowed =
        aboutDevice.stream()
            .anyMatch(permission -> permission.isFor(caller) && permission.covers(feature));
    return allowed
        ? Optional.empty()
        : Optional.of(
            "no maestro:Permission of the home lets %s ask %s for %s"
                .formatted(String.join(" or ", caller), device, feature));
  }
}
