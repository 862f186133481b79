package org.maestro.rats.security;

import java.util.ArrayList;
import java.util.List;

/**
 * The topics that one user of a secured site may write and read, as MQTT filters: everybody speaks
 * under its own name only, and only controllers read what others see, hold and report. Observers
 * read everything, and say nothing.
 */
record TopicRights(List<String> write, List<String> read) {

  static TopicRights of(SiteUsers users, String id) {
    String root = "rats/1/" + users.site() + "/";
    if (users.observers().contains(id)) {
      return new TopicRights(List.of(), List.of(root + "#"));
    }
    boolean controller = users.controllers().contains(id);
    List<String> write = new ArrayList<>();
    write.add(root + "call/" + id);
    write.add(root + "result/+/" + id);
    write.add(root + "progress/+/" + id);
    write.add(root + (controller ? "controller/" + id + "/#" : "member/" + id + "/#"));
    List<String> read = new ArrayList<>();
    read.add(root + "call/#");
    read.add(root + "result/" + id + "/#");
    read.add(root + "progress/" + id + "/#");
    read.add(root + "controller/+/status");
    if (controller) {
      read.add(root + "member/#");
    } else {
      read.add(root + "member/+/status");
      read.add(root + "member/+/description");
      read.add(root + "member/" + id + "/#");
      read.add(root + "controller/+/verdict/" + id);
    }
    return new TopicRights(List.copyOf(write), List.copyOf(read));
  }
}
